import type { Entry } from './entries.ts';

const { raw } = String;

export const en = {
  title: 'Integrators',
  intro:
    'One scene, several methods, one clock: all start from the same state. Pull at the surface and watch who keeps the energy, who loses it and who explodes.',
  opening: 'Opening the scene…',
  hint: 'Take hold of the surface and pull: time runs while you hold it, and goes on when you let go.',
  short: {
    'forward-euler': 'Forward Euler',
    'symplectic-euler': 'Symplectic Euler',
    'linearly-implicit': 'Linearly implicit Euler',
    'newton-once': 'One Newton step',
    newton: 'Newton, converged',
    'local-global': 'Local/global',
    lbfgs: 'L-BFGS',
    anderson: 'Anderson',
    chebyshev: 'Chebyshev',
  } satisfies Record<Entry, string>,
  long: {
    'forward-euler': 'Forward Euler',
    'symplectic-euler': 'Symplectic Euler',
    'linearly-implicit': 'Linearly implicit Euler',
    'newton-once': 'Implicit Euler: one Newton step',
    newton: 'Implicit Euler: Newton to convergence',
    'local-global': 'Implicit Euler: local/global',
    lbfgs: 'Implicit Euler: L-BFGS',
    anderson: 'Implicit Euler: Anderson',
    chebyshev: 'Implicit Euler: Chebyshev',
  } satisfies Record<Entry, string>,
  caption: {
    iterations: '{{name}} × {{count}}',
    substeps: '{{name}}, {{count}} substeps',
    again: '{{name}} ({{number}})',
  },
  methods: {
    heading: 'Methods',
    method: 'Method {{number}}',
    atOnce: 'At once',
    iterated: 'Implicit Euler by',
    iterations: { one: 'iteration', many: 'iterations' },
    substeps: { one: 'substep', many: 'substeps' },
    countOf: '{{name}}: {{count}}',
    substepsHint: 'A time step is made as so many steps of Δt over that number',
    remove: 'Remove {{name}}',
    add: 'Add a method',
  },
  settings: {
    heading: 'The same for all',
    k: 'stiffness',
    mass_scale: 'mass, × the scene’s',
    delta_t: 'time step',
    damping: 'damping',
    gravity: 'gravity',
    pokeHeading: 'The hand that pulls',
    pokeStiffness: 'stiffness of its springs',
    pokeRadius: 'reach, × the scene’s size',
    reset: 'Back to the scene’s value',
    resetPoke: 'Back to the usual value',
    resetAll: 'All back to the scene’s values',
  },
  stability: {
    omega: raw`The fastest oscillation of these springs has $\omega = {{omega}}\,\mathrm{rad/s}$, so $\symdeltaT\,\omega = {{product}}$.`,
    symplectic: {
      holds: 'Symplectic Euler is stable below {{limit}}, and so it holds.',
      explodes:
        'Symplectic Euler is stable below {{limit}}: it explodes unless a time step is cut into {{substeps}} substeps or more.',
    },
    forward: {
      holds: 'Forward Euler with this damping is stable below {{limit}}, and so it holds.',
      explodes:
        'Forward Euler with this damping is stable below {{limit}}: it explodes unless a time step is cut into {{substeps}} substeps or more.',
    },
    never: 'Forward Euler without damping explodes at any step size.',
    implicit: 'The implicit methods have no such limit.',
  },
  note: {
    loses: 'loses {{rate}} a second',
    gains: 'gains {{rate}} a second',
    keeps: 'keeps its energy',
    failed: 'stopped at time step {{step}}: {{sentence}}',
    unstable:
      '{{name}} exploded at time step {{step}}: its Δt·ω had come to {{value}}, and it is stable only up to {{limit}}. Choose more substeps or a smaller Δt, then “Start again”.',
    unbounded:
      '{{name}} exploded at time step {{step}} (Δt·ω = {{value}}). Without damping it always does, with smaller Δt only later. Choose another method or add damping, then “Start again”.',
    grew: '{{name}} exploded at time step {{step}}. Choose a smaller Δt or another method, then “Start again”.',
  },
  energy: {
    heading: 'Energy',
    shown: 'Curves of',
    totals: 'all methods, total',
    time: 'simulated time, s',
    totalOf: 'total energy, J (gravity counted from the rest positions)',
    termsOf: 'energy of {{name}}, J (gravity counted from the rest positions)',
    kinetic: 'kinetic',
    springs: 'springs',
    gravity: 'gravity',
    total: 'total',
    summaryTotals: 'Total energy of every method over the last ten seconds; the table gives the same numbers.',
    summaryTerms: 'Kinetic energy, energy of the springs, of gravity and their sum over the last ten seconds.',
    empty: 'The curves begin with the first time step.',
  },
  error: {
    heading: 'Distance from a method',
    from: 'Measured from',
    label: 'farthest vertex, m',
    summary:
      'How far the farthest vertex of every other method is from where this method has it, over the last ten seconds.',
    alone: 'With a second method, its distance from the first one is drawn here.',
  },
  table: {
    caption: 'Where each method stands',
    method: 'Method',
    energy: 'total energy',
    rate: 'change per second',
    rateHint:
      'Change per second: the slope of the straight line that fits the total energy of the last second of simulated time best. While you pull, the work of your hand counts too.',
    time: 'a time step takes',
    failed: 'stopped',
  },
  instant: {
    heading: 'The same instant',
    text: raw`However far apart the methods have come, put all of them into the motion of one and let each make this one time step. The exact answer $\symp^\star$ is the minimiser of $\symobjective$, found by Newton’s method: it is what implicit Euler means by a time step, and what the iterations of the others are on the way to. For an explicit method the difference is no mistake of solving: it answers another question.`,
    from: 'From the motion of',
    go: 'Take this step by all',
    caption: 'One time step from the motion of {{name}}; finding the minimiser took {{time}}',
    distance: raw`$\max_i \lVert \symp_i - \symp_i^\star \rVert$`,
    objective: raw`$\symobjective - E(\symp^\star)$`,
    time: 'time',
    failed: 'the step failed',
  },
  cards: {
    heading: 'What each method does',
    unifying: raw`All but forward Euler are one move in different metrics. With $\symobjective$ [of one time step](optimisation), whose gradient at $\symp = \sympCurr$ is $-\symf(\sympCurr) - \symM\symvelocity/\symdeltaT$, they take, and those that iterate take again from the new $\symp$,

$$\symp \leftarrow \sympCurr - \mathbf{B}^{-1}\,\nabla E(\sympCurr)$$

and differ in $\mathbf{B}$ alone: the better it stands in for the second derivative of $E$, the larger the steps that end well. Here $\mathbf{K} = \partial\symf/\partial\symp$.`,
    'forward-euler': raw`Moves with the old velocity and only then changes it by the old force: $\symp = \sympCurr + \symdeltaT\,\symvelocity$, $\symvelocity \leftarrow \symvelocity + \symdeltaT\,\symM^{-1}\symf(\sympCurr)$. Every swing comes out a little larger than the one before, by the factor $\sqrt{1 + \symdeltaT^2\omega^2}$ a step: without damping it explodes at any step size ([try it on one spring](optimisation)).`,
    'symplectic-euler': raw`$\mathbf{B} = \symM/\symdeltaT^2$, a diagonal: nothing to solve. The velocity first, then positions with the new velocity. While $\symdeltaT\,\omega < 2$ its energy swings about the true one and neither grows nor fades; beyond, it explodes. The lesson calls it the step [by the forces that are known](optimisation).`,
    'linearly-implicit': raw`$\mathbf{B} = \symM/\symdeltaT^2 - \mathbf{K}$, the second derivative of $E$ at $\sympCurr$: $(\symM - \symdeltaT^2\mathbf{K})\,\symvelocity \leftarrow \symM\symvelocity + \symdeltaT\,\symf(\sympCurr)$. One linear system a time step, with new numbers each time. This is one Newton step of implicit Euler without a line search: nothing holds it back where many springs are compressed, and after a violent pull it may tear the net to pieces.`,
    'newton-once': raw`The same $\mathbf{B}$, made positive definite where compressed springs spoil it, and a line search that never lets $E$ rise: a safer [linearly implicit Euler](optimisation).`,
    newton: raw`Repeats the Newton step at every new $\symp$ until $E$ falls no further (the cloth lab’s report calls $E$, its gradient and second derivative $g$, $\nabla g$ and $\mathbf{H}_g$): the minimiser itself, and so implicit Euler as it is meant. What energy it still loses is the method’s own damping, more with a larger $\symdeltaT$ ([why](time)).`,
    'local-global': raw`$\mathbf{B} = \symQ$, once for all steps: [one local and one global step](trick) are the same as $\symp \leftarrow \symp - \symQ^{-1}\nabla \symobjective$. $\symQ$ never changes, so it is factorised once; it is stiffer than the true second derivative, so a single iteration goes too short a way and looks damped.`,
    lbfgs: raw`Starts from $\mathbf{B} = \symQ$ and corrects it by how the gradient changed over the last iterations.`,
    anderson: raw`$\mathbf{B} = \symQ$, and a combination of the last iterates that nearly cancels what is left to do.`,
    chebyshev: raw`$\mathbf{B} = \symQ$, and every iterate is carried on along the last move.`,
  } satisfies Record<Entry | 'heading' | 'unifying', string>,
};
