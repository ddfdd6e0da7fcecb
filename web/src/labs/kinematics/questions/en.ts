const { raw } = String;

export const en = {
  heading: 'Three questions',
  intro:
    'What students ask when an arm does not do as they wish. Each question comes with an experiment: with the arm above, its joints without limits, and the same solver.',
  methods: { ccd: 'CCD', fabrik: 'FABRIK', 'least-squares': 'Least squares' },
  curves: {
    label: 'Curve',
    both: 'Circle and heart',
    circle: 'Circle',
    heart: 'Heart',
    drawn: 'The curve above',
  },
  unreachable: {
    question: 'What if the target cannot be reached?',
    tryThis:
      'Move the target out along its line until it leaves the disc, and back in. Make the last link longer than all others together: a hole opens around the root, and the arm cannot fold into it. The chart shows what the methods do if nobody asks for the distance first and they only search.',
    picture: 'The arm from the side, in the distances that it can reach',
    distance: 'Distance of the target from the root',
    direction: 'Its direction, from straight down',
    last: 'Length of the last link',
    shown: 'Method in the picture',
    tested: 'distance asked first',
    untested: 'search alone',
    reach: 'reach {{length}}',
    hole: 'hole {{length}}',
    within: 'Within reach: some pose puts the end effector on the target.',
    tooFar: 'UNREACHABLE, after 0 iterations: {{least}} too far even for the stretched arm.',
    tooNear: 'UNREACHABLE, after 0 iterations: {{least}} too near the root even for the folded arm.',
    beside:
      'A second target, one centimetre to the side, lies {{target}}° further around the root. For it the arm turns its links by at most {{arm}}°.',
    iteration: 'iteration',
    beyond: 'error of the search alone, beyond the unavoidable, m',
    summary:
      'Error against iterations for every method that only searches, on a logarithmic axis. Out of reach the curves fall for dozens of iterations, and nothing ends them.',
    jump: 'A curve that jumps up shows a precaution of the solver: an arm that lies on one line with its target could be stuck there, so it is bent a little, once in every search.',
    caption: 'The same target, with the question for its distance and without',
    method: 'method',
    iterations: 'iterations',
    left: 'error beyond the unavoidable',
    creeps: 'moves on next frame',
    ask: 'How can the solver know before its first iteration that a target is out of reach?',
    hint: 'How far from the root is the end effector when the arm is stretched? And when the longest link points one way and all others point back?',
    answer: raw`
      By the lengths $\ell_i$ of the links alone. Stretched, the end effector is $\sum \ell_i$ away from the root. Folded
      over the longest link, it is $2\ell_{\max} - \sum \ell_i$ away; where that is negative, the arm can touch its own
      root. Every distance $d$ of a target in between is possible, and no other:

      $$\max\bigl(0,\ 2\ell_{\max} - \textstyle\sum \ell_i\bigr) \le d \le \textstyle\sum \ell_i$$

      Outside, the best pose needs no search: all links on the line through root and target. The answer is |UNREACHABLE|
      after 0 iterations, with the error that nobody can avoid. And it is calm: where the target moves by a small angle
      around the root, the arm turns by the same angle.

      A method that only searches cannot tell “not yet” from “never”. The straighter the arm, the less a turn of a joint
      brings the end effector forward, so every iteration gains less than the last one. It spends all of its $K$
      iterations, stops wherever it is by then, and in the next frame it creeps on, though the target stands still. That
      creeping is the trembling of arms that strain for something too far away.
    `,
  },
  iterations: {
    question: 'How many iterations do CCD, FABRIK and least squares need?',
    tryThis: raw`Every method looks for 200 targets on the lab’s circle and 200 on its heart, each from the pose for the target before, in double precision and in single. Count; then make $\varepsilon$ larger step by step, and watch CCD in single precision.`,
    epsilon: 'ε, how near is near enough',
    most: 'K, the most iterations for one target',
    go: 'Count for {{targets}} targets',
    name: '{{method}}, {{precision}}',
    double: 'double',
    single: 'single',
    histograms: 'Histograms of the iterations',
    summary: 'median {{median}}, at most {{most}}',
    axis: 'iterations',
    targets: 'Targets that took so many iterations',
    outcomes: {
      CONVERGED: 'within ε',
      STALLED: 'nothing moves any more',
      UNREACHABLE: 'out of reach',
      MAX_ITERATIONS: 'K used up',
    },
    ended: {
      CONVERGED: 'converged',
      STALLED: 'stalled',
      UNREACHABLE: 'out of reach',
      MAX_ITERATIONS: 'K used up',
    },
    caption: '{{targets}} targets, at most K = {{most}} iterations for each',
    method: 'method, precision',
    median: 'median',
    largest: 'most',
    error: 'largest error',
    time: 'time for one',
    work: 'An iteration is not always the same work. One of CCD turns every joint once, and each turn moves all that hangs on it. One of FABRIK passes along the chain backward and forward. One of least squares solves a small linear system for all joints at once. The times are those of this run on this machine, and include that the solver records every event.',
    ask: raw`A report finds that CCD needs more than 100 iterations for $\varepsilon = 10^{-4}\,\mathrm{m}$. In double precision the histogram shows far fewer. Who is right?`,
    hint: 'How do CCD’s searches end in single precision, and how large is the error then? What would a program do that stops only at ε or at K?',
    answer: raw`
      Both have counted correctly. The report’s program took the rotation between two vectors from a graphics library,
      in single precision. Such a function (that of GLM, for example) computes $\cos\theta$ and returns no rotation where
      that is 1 but for the last bits of a float. Once every joint has less than about $5 \cdot 10^{-4}$ rad left to turn,
      nothing moves any more, while the end of an arm of 2.6 m may still be a millimetre away. This solver notices, and
      says |STALLED|. A program that stops only at $\varepsilon$ or at $K$ goes on turning by nothing until $K$, and reports
      “more than 100”, or more than whatever $K$ was.

      So it is neither CCD nor quite the single precision: it is the cosine. From sine and cosine together,
      $\theta = \operatorname{atan2}(\sin\theta, \cos\theta)$, even a float knows every small angle to seven digits. And
      in double precision the cosine’s own limit is at $2 \cdot 10^{-8}$ rad, where nobody notices.

      FABRIK moves joints along straight lines and needs no angle while it searches; least squares computes its small
      turns from a linear system. Neither stalls.
    `,
  },
  angle: {
    heading: 'Where small angles are lost',
    text: raw`Just below 1 the neighbours of a float are $2^{-24}$ apart. For a small angle $\cos\theta \approx 1 - \tfrac12\theta^2$, so the cosines of many different angles are one and the same float.`,
    both: 'from sine and cosine',
    cosine: 'from the cosine alone',
    turned: 'what a library turns by',
    theta: raw`true angle $\theta$, rad`,
    computed: 'angle in single precision, rad',
    summary:
      'Both axes are logarithmic. From sine and cosine the angle is right. From the cosine alone it goes down in steps that become larger, and falls to 0. What a library turns by is right and falls to 0 even sooner.',
    tooSmall: raw`An error of $\varepsilon$ at the end of the stretched arm is an angle of {{root}} rad at the root (the line in the chart); at the end of the last link, {{last}} rad at its joint. The library turns by nothing below {{unknown}} rad: CCD can stall before it is near enough.`,
    enough: raw`An error of $\varepsilon$ at the end of the stretched arm is an angle of {{root}} rad at the root (the line in the chart); at the end of the last link, {{last}} rad at its joint. Both are more than the {{unknown}} rad below which the library turns by nothing: what is still missing can be turned.`,
  },
  jitter: {
    question: 'Why does the arm jitter between frames, and what does a rotation limit do?',
    tryThis:
      'The arm follows a curve, one target a frame. Compare two ways to start the searches: each picture lays eight poses in a row over each other. Go through the targets with the slider. Then choose the limit for one side, and make it tighter.',
    names: {
      warm: 'From the pose before',
      hanging: 'From the hanging arm',
      random: 'From a random pose',
      limited: 'From the pose before, with the limit',
    },
    sides: { first: 'First way to start', second: 'Second way to start' },
    count: 'Targets on the curve',
    limit: 'Limit: a joint turns per target at most',
    place: 'Target in the picture',
    picture: 'The arm’s poses for targets {{first}} to {{last}}; the earlier ones fade.',
    target: 'target',
    turn: 'largest turn of a joint since the target before, °',
    error: 'distance from the target, m',
    turnSummary: 'Largest turn of a joint at every target, for both ways, on a logarithmic axis.',
    errorSummary: 'Distance of the end effector from every target, for both ways, on a logarithmic axis.',
    caption: 'Along the whole curve, from one target to the next',
    way: 'search starts',
    largest: 'largest turn',
    mean: 'mean turn',
    largestError: 'largest error',
    missed: 'targets missed',
    ask: 'Without the limit, the end effector is on the same targets either way. Why are the poses so different? And what does the limit cost?',
    hint: 'A target fixes three numbers. How many can the joints choose?',
    answer: raw`
      A target fixes the three coordinates of the end effector, and nothing else. Every joint can turn about three axes,
      so the arm has more freedom than the target takes away: infinitely many poses reach it, and a search ends at one
      near its start. From the pose before, that is the neighbour of the pose before, and the arm moves calmly. From a
      random pose it is another one every time. Each is right; shown one after the other, they jitter.

      From the hanging arm the start is always the same, and the poses follow each other nearly everywhere without a
      jump. But the heart begins at its cusp, straight below the root. For that target the hanging arm may bend to any
      side; for the next one only one side will do, and the arm jumps to it.

      A rotation limit holds back every joint that wants to turn further from one target to the next. Nothing can jump
      any more. The price is the error: a target that is too far away for one frame’s turns is not reached in that
      frame, and the arm lags behind. A motor, which has a highest speed, needs such a limit. To draw a curve well, it is better
      to start from the pose before and to put the targets closer together: then the limit is never met.

      FABRIK bears the limit worst. It moves points and knows no rotations; only after a pass can these be held, and the next
      pass moves the points as if nothing had held them. CCD and least squares turn joints, and let the others turn further
      for the one that is held.
    `,
  },
};
