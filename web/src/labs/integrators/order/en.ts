const { raw } = String;

export const en = {
  heading: 'Order of accuracy: one spring, shorter and shorter steps',
  intro: raw`How much of a method’s error goes away when $\symdeltaT$ is halved is what its **order** says: half of it with order 1, three quarters with order 2. With both axes logarithmic, the error against $\symdeltaT$ becomes a straight line as $\symdeltaT$ gets small, and the order is its slope.`,
  running: 'One spring is taking tens of thousands of time steps…',
  failed: 'The experiment could not be run. {{reason}}',
  again: 'Try again',
  cases: { label: 'Motion of the spring', line: 'Along a line', swing: 'Swinging' },
  setting: {
    line: raw`A mass of 1 kg on a spring that is fixed at its other end, let go 0.2 m too far out, without gravity. It moves along the spring with a period of 1 s, and its place is known exactly: $x(t) = r + x_0\cos\omega t$. Every method takes it to $T = 5/8\,\mathrm{s}$, in 16, 32, 64, … 2048 time steps. That time is chosen with care: the largest part of the error goes with $\cos\omega T$ for forward and implicit Euler and with $\sin\omega T$ for symplectic Euler, and where such a factor is 0, as after a quarter of a period or a half, a method of order 1 passes for one of a higher order.`,
    swing: raw`Now with gravity, and with a stiffer spring of 400 N/m: let go level at its rest length of 1 m, it falls, and the spring turns. No formula says where the mass is at $T = 0.8\,\mathrm{s}$. The errors are measured from a reference: symplectic Euler whose first step takes half the force, which makes it the method of Störmer and Verlet, of order 2, in 8192 and in 16384 time steps, extrapolated to $\symdeltaT = 0$. Twice as many move it by less than $10^{-9}\,\mathrm{m}$.`,
  },
  seen: {
    line: raw`All of them are of order 1, symplectic Euler too: what it is better at is the energy. Three of the methods are one and the same line. As long as the spring does not turn, the [local step](trick) finds the right $\symd$ at once, $\symobjective$ is a parabola, and a single solve finds its minimum.`,
    swing: raw`Ten iterations of local/global are as good as Newton’s method but for the longest time step. One iteration gives another answer: even with the finest $\symdeltaT$ it is some thirty times as far away as implicit Euler. Its error does go to zero with $\symdeltaT$, and the slope comes near 1 only there. The reason: $\symQ$ takes a spring for as stiff sideways as it is lengthwise. So one iteration divides the sideways velocity by $1 + \symdeltaT^2\symk/\symm$ in every time step: a friction of the rate $\symdeltaT\,\symk/\symm$ that nothing in the model has. A second iteration makes good for it up to a remainder that vanishes much faster: its line falls steeply onto that of implicit Euler.`,
  },
  errors: {
    heading: 'Error against the time step',
    slope: 'slope {{slope}}',
    delta_t: raw`$\symdeltaT$, s`,
    error: 'distance from the right place at T, m',
    summary:
      'Error of every method against the time step, both axes logarithmic. The lines rise to the right; the table gives their slopes.',
    caption: 'Slopes, fitted to the four finest time steps',
    method: 'Method',
    order: 'slope',
    finest: 'error with the finest',
  },
  energy: {
    heading: 'Energy of the spring on the line',
    text: raw`Here the energy can be computed by hand. In every time step forward Euler multiplies it by $1 + \symdeltaT^2\omega^2$, and implicit Euler divides it by the same number ([why the lesson’s method brakes](time)). Symplectic Euler keeps it between $1/(1 + \tfrac12\symdeltaT\omega)$ and $1/(1 - \tfrac12\symdeltaT\omega)$ of what it was at first, for ever, while $\symdeltaT\,\omega < 2$ ([what happens beyond](optimisation)).`,
    product: 'Time step, Δt·ω',
    productText: 'Δt·ω = {{product}}',
    limit: 'limit of symplectic Euler: 2',
    stable: '{{steps}} time steps a period.',
    unstable: '{{steps}} time steps a period: with a Δt·ω of 2 or more symplectic Euler explodes as well.',
    time: 'simulated time, periods',
    ratio: 'energy over that at the start',
    summary:
      'Energy over five periods: with forward Euler it rises, with implicit Euler it falls, with symplectic Euler it swings within a band.',
    caption: 'What becomes of the energy',
    method: 'Method',
    measured: 'measured',
    predicted: 'predicted',
    methods: {
      'forward-euler': 'Forward Euler',
      'symplectic-euler': 'Symplectic Euler',
      newton: 'Implicit Euler',
    },
    aStep: '× {{factor}} a step',
    aPeriod: '× {{factor}} a period',
    band: '{{least}} to {{most}} times',
    unbounded: 'without bound',
  },
};
