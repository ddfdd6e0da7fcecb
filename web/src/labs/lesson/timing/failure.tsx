import { t } from '../../../app/messages/index.ts';
import { Obstacle } from '../../../app/obstacle.ts';
import { SceneProblem } from '../../../app/scene_problem.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { lessonWords } from '../lesson_words.ts';

/** Why there are no times, if there is a reason. */
export function Failure({ reason }: { reason: unknown }) {
  if (reason === null) return null;

  const sentence =
    reason instanceof Obstacle || reason instanceof SceneProblem ? t(reason.key, reason.params) : String(reason);
  return (
    <p class="figure-refusal" role="alert">
      {fillTemplate(lessonWords().timingFailed, { reason: sentence })}
    </p>
  );
}
