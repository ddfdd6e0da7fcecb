const { raw } = String;

export const en = {
  intro: raw`[Three positions](time) make an acceleration. Newton’s law for vertex $i$, with the forces at the **end** of the step, where they
depend on the unknown $\symp$, is then an equation for $\symp$. With everything on one side:`,
  terms: {
    gradient: raw`Each of the three terms is the derivative of something by $\symp_i$. Call the sum of these somethings $\symobjective$; then the
equation says $\symgradient = 0$. That is what holds at the bottom of a valley. So instead of solving an equation we may **look for the lowest
point of a landscape**.`,
    title: 'Three wishes in one sum',
    wishes: raw`- The springs, $\sympotential$, want their rest lengths.
- Inertia, $\syminertia$, wants every vertex to go straight on, to $2\sympCurr_i - \sympPrev_i$, and the more so the heavier it is and the
shorter the step.
- The external force, $\symexternal$, wants to push as far as it can: gravity wants down.

They cannot all have their way. The time step ends where their sum is smallest:`,
  },
  landscape: {
    shown: 'The map shows',
    terms: { sum: 'the sum', springs: 'springs', inertia: 'inertia', external: 'external force' },
    values: 'At the present p',
    caption: raw`One spring, one vertex that can move: its $\symobjective$ is a map of the plane. Thin lines join places of equal energy, the
strongest are the lowest. Cross: where inertia and gravity alone would lead. Dots: the iterates of this time step; the ring is the last of them.
Press ½▶ to walk down.`,
    seen: raw`Look at the terms one by one: a ring of rest lengths around the pin, a round bowl, a slope. Now change $\symdeltaT$. In a short
step inertia’s bowl is so steep that little else counts; in a long one the ring wins. At the last iterate $\lVert\symgradient\rVert$ is close
to 0, and there Newton’s law holds. How close [other methods come on a whole net](springs/convergence) is shown in the lab.`,
  },
  nonlinear: {
    title: 'Why it is not a linear equation',
    ask: raw`The acceleration is linear in $\symp$. Why is the whole equation not?`,
    hint: raw`What would $\symobjective$ look like along a straight line if all its derivatives were linear? And what does a spring do on
either side of its pin?`,
    answer: raw`Because of the length $\lVert\symp_i - \symp_j\rVert$, a square root. A linear force belongs to an energy that is a parabola along
every line, with one lowest point. Pull the vertex along a level line through the pin: the spring is content at one rest length to the left **and**
at one to the right, and between them there is a peak.`,
    spring: 'energy of the spring',
    energy: raw`$\sympotential$, J`,
    offset: 'Distance from the pin, to the right, m',
    summary:
      'The energy of the spring along a line through its pin: zero at one rest length on either side, a peak in between.',
  },
  explicit: {
    title: 'Why not take the forces that are known?',
    ask: raw`With the forces at $\sympCurr$ in place of those at $\symp$ nothing would have to be solved. What would happen?`,
    hint: raw`A stiff spring, pulled a little too long, pulls back hard. If this pull is held for a whole step, how far does the vertex go?`,
    answer: raw`Each step would be a single formula, and an **explicit** one:

$$\symp_i = 2\sympCurr_i - \sympPrev_i + \frac{\symdeltaT^2}{\symm_i}\,\symf_i(\sympCurr)$$

A vertex on one spring swings with $\omega = \sqrt{\symk/\symm}$. If $\symdeltaT\,\omega$ is more than 2, each step overshoots the rest length by
more than the last. Press play, then lower $\symk$ or $\symdeltaT$ until it holds.`,
    atStart: 'Forces at the start of the step',
    atEnd: 'Forces at its end',
    reading: 't = {{time}}\nenergy {{gained}}',
    left: 'The vertex left the picture at t = {{time}}.',
    stable: raw`$\omega = {{omega}}\,\mathrm{s}^{-1}$, $\symdeltaT\,\omega = {{product}} < 2$: **stable**.`,
    unstable: raw`$\omega = {{omega}}\,\mathrm{s}^{-1}$, $\symdeltaT\,\omega = {{product}} \geq 2$: **unstable**.`,
    energy: 'Change of energy since the start, J',
    time: 'Simulated time, s',
    summary:
      'Energy over simulated time: beyond the limit it grows without bound with the forces at the start of the step, and never with those at its end.',
    seen: raw`Below the limit explicit steps keep the energy better than implicit ones. But a net has as many $\omega$ as it has ways to swing,
and the fastest alone dictates $\symdeltaT$. The implicit step is stable with any.`,
    lab: 'A whole cloth by both explicit Euler methods and an implicit one, side by side, in the integrators lab',
  },
  slips: {
    title: 'E in print',
    intro: raw`If you read the course text beside this page, you will meet other signs. It is easy to find out who is right: move a vertex by a
hair, see how much $\symobjective$ changes, and compare with the forces.`,
    sign: {
      title: 'A minus before inertia',
      why: raw`With the minus the derivative is $-\symm_i\syma_i - \symf_i$, and at its zero vertices fall upwards.`,
    },
    half: {
      title: 'Inertia without its ½',
      why: raw`One edition has no ½. Squares bring a 2 when they are differentiated, and without the ½ it stays: every mass counts twice.`,
    },
    previous: {
      title: raw`A minus before the older position`,
      why: raw`Some of the matrix forms have it. A vertex at rest, all three positions equal, must cost nothing; here it costs the more the
farther it is from the origin.`,
    },
    delta_t: {
      title: 'Δt without its square',
      why: raw`One of the matrix forms divides by $2\symdeltaT$. Units tell: kg m²/s² is an energy, kg m²/s is not.`,
    },
    external: {
      title: 'No minus before the external force',
      why: raw`In one matrix form. The derivative of $-\symp_i^{\mathrm T}\symfExt_i$ is $-\symfExt_i$, as Newton’s law has it; without the minus
gravity pulls up.`,
    },
  },
  sources: {
    jacobson:
      'A. Jacobson, Computer Graphics – Mass-Spring Systems (course text): “Time integration as energy optimization”.',
    liu: 'T. Liu, A. Bargteil, J. O’Brien, L. Kavan, Fast Simulation of Mass-Spring Systems, 2013: section 3.',
    witkin:
      'A. Witkin, D. Baraff, Physically Based Modeling (course text): “Differential Equation Basics” and “Implicit Methods”.',
    nocedal: 'J. Nocedal, S. Wright, Numerical Optimization: chapter 2, conditions for a minimum.',
  },
};
