const { raw } = String;

export const en = {
  intro: raw`
    A time step looks for the lowest point of a landscape, $\symobjective$ ([why](optimisation)). Local and global step go
    down to it by turns ([how](trick)) and stop after $K$ of them, wherever they are. How far do they come? And how far do
    other methods, from the same start?
  `,
  closed: {
    title: 'How much of the gap is closed',
    sentence: raw`
      In time step {{step}}, **{{iterations}} iterations** of local and global step close **{{share}}** of the gap between
      $\symobjective$ at the start and the lowest $\symobjective$ found. The stiffness number is
      **$\symkappa$ = {{kappa}}**.
    `,
    percent: '{{percent}} %',
    nearlyAll: 'all but {{left}}',
    all: 'all, up to rounding,',
    computing: raw`Finding the lowest $\symobjective$ of time step {{step}} …`,
    nothing: raw`In time step {{step}} there is nothing to close: it starts where $\symobjective$ is lowest.`,
    givenUp: raw`
      An iteration of this scene takes long: only {{made}} were made here, and the time step ends later. The stiffness
      number is **$\symkappa$ = {{kappa}}**.
    `,
    playing: raw`The clock runs. Pause it, and this time step is compared.`,
    why: {
      ask: raw`Why does $\symkappa$ decide?`,
      answer: raw`
        At every vertex, $\symkappa$ compares the springs with inertia:

        $$\symkappa = \max_i \frac{\symdeltaT^2}{\symm_i} \sum_j \symk_{ij}$$

        A spring resists being stretched, with $\symk$. It does not resist being turned: only inertia, $\symm/\symdeltaT^2$,
        does. The global step does not know that. It holds every $\symd$ still, and so its matrix $\symQ$ resists turning
        as it resists stretching. Parts that have to turn therefore move too little: in the worst case about one part in
        $1 + \symkappa$ of their way, here **1 in {{oneIn}}**, in every iteration. L-BFGS and Newton’s method learn or know
        how $\symobjective$ really bends.

        Make $\symk$ or $\symdeltaT$ smaller and watch the curve of local and global step become steeper.
      `,
    },
    net: 'Try the net',
    flag: 'Try the stiff flag',
    flagHint: 'k = 100000 N/m',
  },
  levels: {
    title: 'Two clocks, one inside the other',
    text: raw`
      On the upper line time goes on, by $\symdeltaT$ a tick. On the lower line it stands still: it is one tick of the upper
      one, spread out, and on it $\symp$ is looked for. Ticks to the left are remembered; those to the right of the thumb are
      computed anew, with what is set now.
    `,
    step: 'New with every time step',
    halfStep: 'New with every half-step',
    local: 'local',
    global: 'global',
    neither: 'New in neither',
    unless: raw`unless $\symk$, $\symdeltaT$, $\symm$, $\symw$, the springs or the set of pins change`,
  },
  damped: {
    title: 'Few iterations look damped',
    text: raw`
      With few iterations each step stops short of its minimum, still near its start $\sympCurr$. What has not moved in this
      step has no velocity in the next, $(\sympCurr - \sympPrev)/\symdeltaT$. So energy is lost to the unfinished solve:
      there is no friction in any formula, and yet the net sinks “as if embedded in peanut butter”.
      Implicit Euler damps by itself, too: on the net, that is all that $K = 50$ still loses.

      Let three copies go on from the lab’s present moment, and look at what is left of the energy. Drag a pin: it moves in all
      three. Reset the lab first to see them start at rest.
    `,
    start: 'Let them go, with 1, 10 and 50 iterations',
    again: 'Again, from the lab’s present moment',
    count: 'K = {{iterations}}',
    note: 'energy of motion {{kinetic}}',
    energy: 'Energy of motion, springs and outer forces together, J',
    time: 'time, s',
    summary: 'The total energy over time, with 1, 10 and 50 iterations a time step.',
  },
};
