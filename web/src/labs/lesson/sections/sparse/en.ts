const { raw } = String;

export const en = {
  which: raw`
Entry $(i, j)$ of $\symQ$ differs from zero for two reasons only: $i = j$, or a spring joins $i$ and $j$. A spring adds
$\symk$ at $(i, i)$ and at $(j, j)$, and $-\symk$ at $(i, j)$ and at $(j, i)$; masses and pins add to the diagonal. So there
are $\symvertexCount + 2\,\symspringCount$ entries, out of $\symvertexCount^2$. Counted in the solver’s own matrices:
`,
  counts: {
    caption: 'Entries of Q',
    scene: 'scene',
    all: 'all',
    nonZero: 'not zero',
    share: 'share',
  },
  list: raw`
A **sparse matrix** stores only those, row after row, each with its column. To make one, write a list of **triplets**
$(i, j, \text{value})$, in any order, and hand over the whole list: |Q.setFromTriplets(begin, end)|. Triplets for the same
place **add up**. A sum over springs is just that: every spring writes its four and need not ask who was there before.
`,
  triplets: {
    caption: raw`One triplet at a time: four for each spring, one for each mass and each pin. Insert all of them, then change
**add** to **overwrite**, and then move the slider.`,
    steps: 'Triplets inserted',
    repetition: 'A second triplet for the same place',
    add: 'adds (+=)',
    overwrite: 'overwrites (=)',
    none: 'Nothing is stored yet.',
    spring: '({{i}}, {{j}}, {{value}} N/m) from spring {{index}}',
    mass: '({{i}}, {{j}}, {{value}} N/m) from mass {{index}}',
    pin: '({{i}}, {{j}}, {{value}} N/m) from the pin at vertex {{index}}',
    matrix: 'Q: {{stored}} of {{all}} entries stored',
  },
  report: {
    moved: 'A global step with this matrix misses the right positions by up to {{distance}}.',
    failed: 'No global step: in row {{row}} Cholesky needs the square root of {{pivot}}.',
  },
  overwriting: raw`
With |=| only the last triplet of each diagonal place survives: the springs’ share is lost there, but not beside it. The rows
of the springs’ part no longer add up to zero, so the net is pushed away from the origin of the coordinates (the arrows),
which no spring should know of. Make the springs stiffer, and the matrix is not even positive definite: there is no
$\symL$.
`,
  entryByEntry: {
    ask: raw`Why a list? I could write |Q.coeffRef(i, j) += v| straight into the sparse matrix.`,
    hint: 'The entries lie in memory without gaps. What has to happen to those behind a new one?',
    answer: raw`They all move up by one place, for every new entry. The sum comes out right (with |=| it would not), but how long it
takes depends on the order, and at worst grows with the square of the number of entries. A library can leave gaps to put that
off. A list needs none: it is counted and put in order once, whatever its order. Counted now:`,
  },
  insertion: {
    counting: 'Counting…',
    caption: 'How often entries of the flag are moved, inserting its {{triplets}} triplets one by one',
    written: 'in the order of the springs',
    backwards: 'the same backwards',
  },
  slowFlag: {
    ask: 'All my matrices are sparse, and the flag still takes 5 to 10 seconds a frame. Why?',
    hint: raw`Print the length of your list of triplets, or |Q.nonZeros()|, and compare with the table above.`,
    answer: raw`A triplet with the value 0 is a triplet. It is stored, and every multiplication and every substitution visits it.
Two loops over all $i$ and all $j$ that push an entry each make a dense matrix in sparse clothes. The other way to get there
is a dense matrix somewhere between sparse ones. So write triplets in a loop over **springs**. Here is the flag with its
zeros left out and with all of them stored; the second takes a while and some 350 MB, the page does not wait.`,
  },
  flag: {
    start: 'Time one frame of the flag',
    stop: 'Stop',
    tooLarge: 'The solver refuses: so many zeros do not fit into its memory.',
    caption: 'The flag on the plain path, 50 iterations',
    precomputation: 'precomputation',
    step: 'one time step',
    sparse: 'zeros left out',
    dense: 'zeros stored',
  },
  fillTitle: 'Fill-in',
  fillIn: raw`
The factor does not keep all zeros. Eliminating vertex $i$ ties all its remaining neighbours to each other: springs that were
never there, but $\symL$ needs entries for them. This is **fill-in**, and how much there is depends on the order in which
the vertices are eliminated. So solvers permute first, $\symP\symQ\symP^{\mathrm T} = \symL\symL^{\mathrm T}$: the vertices
are renumbered, nothing else. A simple good rule: next comes the vertex with the fewest neighbours left.
`,
  fill: {
    order: 'Order of elimination',
    natural: 'as numbered',
    minimumDegree: 'fewest neighbours first',
    Q: 'Q, renumbered: {{Q}} of {{all}} entries',
    L: 'L: {{L}} entries, {{filled}} of them fill-in',
    caption: 'The net of 61 vertices. Coloured: fill-in.',
  },
  sources: {
    jacobson: 'A. Jacobson, Computer Graphics – Mass-Spring Systems (course text): “Sparse Matrices”.',
    davis:
      'T. Davis, Direct Methods for Sparse Linear Systems, 2006: chapter 2, triplets and compressed storage; chapter 7, orderings against fill-in.',
    george: 'A. George, J. Liu, The Evolution of the Minimum Degree Ordering Algorithm, SIAM Review 31, 1989.',
    eigen: 'Eigen, Sparse matrix manipulations: “Filling a sparse matrix”.',
  },
};
