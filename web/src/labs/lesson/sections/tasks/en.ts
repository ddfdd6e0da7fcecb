const { raw } = String;

export const en = {
  intro: raw`
Seven functions make the simulation. If you take a course, you will write them yourself; here is what goes into each, what comes out, and which formula it is. Below each is the solver’s own version: the very file that this page was compiled from. **Try first, compare afterwards.**

Point at a symbol in the code, and the same thing lights up in the formulas and in the figure; choose a spring and its symbols light up in the code.`,
  caption: 'What the functions work on. Step through a time step and follow it in the code below.',
  open: 'Show the solver’s version',
  tasks: {
    lengths: {
      title: 'edge_lengths',
      text: raw`In: positions $\symV$, #V × 3, and springs $\symE$, #E × 2. Out: $\symr$, #E numbers in metres. Called once, with the rest positions.`,
    },
    incidence: {
      title: 'signed_incidence_matrix_dense',
      text: raw`In: #V and $\symE$. Out: $\symA$, #E × #V, zero but for a $+1$ and a $-1$ in every row. Nothing but a loop over the springs.`,
    },
    precomputation: {
      title: 'fast_mass_springs_precomputation_dense',
      text: raw`In: rest positions, springs, masses, pins, $\symk$, $\symdeltaT$, $\symw$. Out: $\symr$, $\symA$, $\symM$, $\symC$ and the factor of $\symQ$. Everything that no time step changes.`,
    },
    step: {
      title: 'fast_mass_springs_step_dense',
      text: raw`In: what the precomputation left, $\sympCurr$, $\sympPrev$ and $\symfExt$. Out: the next positions $\symp$. First $\symy$, once; then local and global step in turn, often enough.`,
    },
    sparseIncidence: {
      title: 'signed_incidence_matrix_sparse',
      text: raw`The same $\symA$, with its zeros left out. The triplets are the same as before; only what is made of them differs.`,
    },
    sparsePrecomputation: {
      title: 'fast_mass_springs_precomputation_sparse',
      text: raw`As before, but no matrix with zeros may appear on the way: not as a product of dense matrices, not as a triplet of value zero. $\symQ$ is put together from what every spring, mass and pin adds to it.`,
    },
    sparseStep: {
      title: 'fast_mass_springs_step_sparse',
      text: raw`Word for word the dense one. If the first six functions are right, there is nothing left to do.`,
    },
  },
  mistakes: {
    damped: {
      ask: raw`Your net moves as if in honey, and a spring that should swing only creeps. Which line of the step would you look at?`,
      hint: raw`How often is $\symd$ computed in a time step of 50 iterations?`,
      answer: raw`Probably the local step stands before the loop instead of in it. Then $\symd$ keeps the directions of $\sympCurr$, all iterations after the first solve the same system again, and the net does as much as **one** iteration would do. Compare below: the same scene with 1 and with 50 iterations.`,
      caption: 'Set K to 1, play, then to 50.',
    },
    k: {
      ask: raw`Your net collapses, or flies apart, as soon as $\symk$ is not 1. What is missing?`,
      hint: raw`$\symk$ stands in $\symQ$. Where else?`,
      answer: raw`In $\symb = \symk\symA^{\mathrm T}\symd + \symy$. Without it the matrix asks for springs of stiffness $\symk$ and the right side for springs of stiffness 1; the lengths on which they agree are about $\symk$ times too short.`,
    },
    order: {
      ask: raw`The first steps look right, then the net creeps as if it had no inertia. Your friend’s jumps up and down, each time farther than before. What could be the wrong way round in yours, and what in hers?`,
      hint: raw`What is $\sympCurr - \sympPrev$, divided by $\symdeltaT$?`,
      answer: raw`$\sympCurr - \sympPrev$ is the velocity. In yours $\sympCurr$ takes over $\symp$ **before** $\sympPrev$ takes over $\sympCurr$: then both are the same, and every step starts at rest. In hers the two are swapped in $2\sympCurr - \sympPrev$: the velocity has the wrong sign, so that inertia throws everything back past where it came from, about twice as far in every step. Below, hers beside the right one.`,
    },
    slow: {
      ask: raw`The flag takes five seconds a frame. Your functions are correct. What now?`,
      hint: raw`Count the triplets, and count the factorisations.`,
      answer: raw`Two usual reasons: triplets of value zero (a loop over all pairs that adds $0$ where there is no spring makes $3321^2$ of them), or a factorisation in every step or iteration. The first belongs to [section 8](sparse), the second to [section 7](solving). And compile with optimisation: Eigen without it is tens of times slower.`,
    },
  },
  nets: {
    captions: {
      k: 'The same triangle twice, k = 100 N/m, the second without k in b. Play, and read how long its springs are.',
      order: 'Play, or go step by step: the first few steps tell. Then start again, and follow the jumps.',
      slow: 'The same tower three times, all with the same positions. Step, and compare what a time step takes.',
    },
    names: {
      none: 'Right',
      'k-forgotten': 'k forgotten in b',
      'times-swapped': 'Signs swapped',
      'stored-zeros': 'Zeros stored in Q',
      'factorised-again': 'Factorised in every iteration',
    },
    length: 'springs at {{percent}} % of their rest length',
    kinetic: 'kinetic energy {{energy}}',
    failed: 'stopped: too far away in time step {{step}}',
    cost: '{{time}} a time step, {{count}} factorisations so far',
  },
  cabinet: 'Ten usual mistakes to watch, each beside the right solver, and a quiz on them',
  sources: {
    jacobson:
      'A. Jacobson, Computer Graphics – Mass-Spring Systems (course text): “Tasks”; the names of the functions are the course’s.',
    own: 'The code is this project’s own (MIT licence), written from the formulas: folder wasm/core.',
  },
};
