const { raw } = String;

export const en = {
  action: raw`
Every global step asks for the positions that satisfy

$$\symQ\symp = \symb$$

On paper one writes $\symp = \symQ^{-1}\symb$. Read it as **an action, not as a matrix**: find what $\symQ$ turns into
$\symb$. Nobody needs to see the numbers in $\symQ^{-1}$.

The action is easy when $\symQ$ is a product of two triangles. $\symQ$ is symmetric and positive definite, because
every mass, spring and pin adds a square to the energy. So there is a lower triangular $\symL$, the
**Cholesky factor**, with

$$\symQ = \symL\symL^{\mathrm T}$$

and one hard system becomes two that can be solved by reading:

$$\symL x = \symb \qquad \symL^{\mathrm T}\symp = x$$

The first row of $\symL x = \symb$ has one entry, so a division gives $x_0$. Then the second row has one unknown left, and
so on down: **forward substitution**. The other system is read from its last row up: **backward substitution**.
`,
  substitution: {
    caption: raw`Step through both substitutions. The numbers are those of the net, for its heights: the middle column of $\symb$
and $\symp$. Then pull at a vertex, and move the slider: what changes $\symL$?`,
    steps: 'Rows solved',
    start: 'The first row of the left table has one entry that is not zero.',
    forwards: 'Down',
    backwards: 'Up',
    residual: 'Solved: no row of Q p differs from b by more than {{residual}} N.',
    counted:
      'For these two tables, since you opened this page: factorisations {{factorised}} (one for every new Q), solves {{solved}} (one for every new Q or b).',
  },
  precompute: raw`
Pulling changes $\symb$, and $x$ and $\symp$ with it. $\symL$ stays. It changes only with $\symQ$: when $\symk$,
$\symdeltaT$, $\symw$, a mass, a spring or the set of pinned vertices does.

So a solver has two calls. **Precompute** factorises, once. **Solve** substitutes, in every iteration of every time step.
At 50 iterations a time step and 30 time steps a second, one factorisation serves 1,500 solves every second.
`,
  refactorise: {
    ask: 'I factorise inside the loop over the iterations, and the picture is right. Is that right?',
    hint: raw`
Which letters stand in

$$\symQ = \symk\symA^{\mathrm T}\symA + \symM/\symdeltaT^2 + \symw\symC^{\mathrm T}\symC$$

and which of them change inside the loop?
`,
    answer: raw`The positions are right, the work is wasted: neither $\symp$ nor $\symd$ nor $\symb$ stands in $\symQ$, so every
factorisation finds the $\symL$ that you already had. Let the clock say what that costs:`,
  },
  refactorising: {
    start: 'Time both',
    running: 'Timing…',
    caption: 'The solves of one time step: {{iterations}} iterations, n = {{n}} vertices',
    once: 'factorised before',
    everyTime: 'factorised every time',
    ratio: 'ratio',
    dense: 'dense',
    sparse: 'sparse',
  },
  costTitle: 'What it costs',
  cost: raw`
Count additions and multiplications for $n$ vertices. A dense factorisation is three nested loops, about $\tfrac13 n^3$; the inverse
takes about $2n^3$. A substitution visits each entry of a triangle once, with one of either: $2n^2$ for a column of $\symb$, down and up.

But most entries of $\symQ$ are zero. If only the others are stored, and the vertices are eliminated in a good order, a net
in the plane takes about $n^{1.5}$ to factorise, and hardly more than $n$ to solve with.

Do not believe it: measure it. The button times all five on square nets of 25 and more vertices, on your machine, while the
page goes on.
`,
  timing: {
    start: 'Start the clock',
    again: 'Measure again',
    stop: 'Stop',
    progress: 'Nets measured',
    finished: 'Finished',
    plot: 'Time of each call against n, both axes logarithmic. Numbers in the tables below.',
    axes: { n: 'n, vertices', time: 'Time of one call, ms' },
    exponents: 'How the time grows with n',
    call: 'call',
    theory: 'theory',
    measured: 'here',
    points: '{{points}} points',
    caption:
      'Ten nets, each with about twice the vertices of the last. Lines: powers of n fitted by least squares. What took longer than a quarter of a second is not tried on larger nets.',
    calls: {
      dense_inverse: 'dense inverse',
      dense_factorise: 'dense factor',
      dense_substitute: 'dense solve',
      sparse_factorise: 'sparse factor',
      sparse_substitute: 'sparse solve',
    },
  },
  reading: raw`
Your exponents will be near the theory, not equal to it, and differ from run to run. On small nets a call costs more than
its arithmetic, so all lines begin flat; only the four largest nets are fitted. Large matrices leave the processor’s fast
cache, which makes lines steeper for a while. A browser’s clock ticks coarsely, so short calls are repeated until they fill
20 ms. And other programs share your processor.
`,
  whyNotInverse: {
    ask: raw`Why not compute $\symQ^{-1}$ once, and multiply by it in every iteration?`,
    hint: 'Push one vertex of a net. Which others move?',
    answer: raw`Column $j$ of $\symQ^{-1}$ says where every vertex goes when one newton pushes vertex $j$. The net holds together,
so all of them move, if only a little: no entry is zero. Multiplying reads $n^2$ numbers, and finding them takes about six
dense factorisations. The triangle keeps most zeros. For the net of 61 vertices, counted now:`,
  },
  inverse: {
    Q: 'Q: {{count}} of {{all}} entries are not zero',
    L: 'L: {{count}} of {{all}}',
    inverse: 'Q⁻¹: {{count}} of {{all}}',
  },
  sources: {
    jacobson:
      'A. Jacobson, Computer Graphics – Mass-Spring Systems (course text): “Matrices”, solving as the action of an inverse.',
    liu: 'T. Liu, A. Bargteil, J. O’Brien, L. Kavan, Fast Simulation of Mass-Spring Systems, 2013: section 4, a matrix that can be factorised beforehand.',
    golub:
      'G. Golub, C. Van Loan, Matrix Computations, 4th edition: section 3.1, triangular systems; section 4.2, positive definite systems.',
    george: raw`A. George, Nested Dissection of a Regular Finite Element Mesh, SIAM Journal on Numerical Analysis 10, 1973: $n^{1.5}$ and $n\log n$.`,
    davis: 'T. Davis, Direct Methods for Sparse Linear Systems, 2006: chapters 3 and 4.',
  },
};
