const { raw } = String;

export const en = {
  intro: raw`
The formulas so far have one index for every vertex and two for every spring. They are right, and slow to write, to read and to compute. Written with matrices, the loops over vertices and springs become products, and two steps of algebra lead to the linear system that the global step solves.

Put the positions of all vertices under each other: $\symp$ has one row for every vertex and three columns. The vectors of all springs, $\symp_i - \symp_j$, are then one product. $\symA$ has a row for every spring, with $+1$ in the column of $i$ and $-1$ in that of $j$:

$$\symv = \symA\symp$$`,
  product: {
    caption:
      'Choose a spring, a row or an entry: the same thing lights up in the picture and in all three tables. Pull at a vertex: A stays, p and v change.',
  },
  trace: {
    title: 'Sums of squares as traces',
    springs: raw`
The sum of the squares of all entries of a matrix $\mathbf{X}$ is the trace $\operatorname{tr}(\mathbf{X}^{\mathrm T}\mathbf{X})$: its diagonal holds the squared length of every column. So the springs, with $\symd$ held as in [the last section](trick), are

$$\begin{aligned} & \sum_{ij} \tfrac12\symk\lVert(\symp_i - \symp_j) - \symd_{ij}\rVert^2 \\ & \quad = \tfrac12\symk\operatorname{tr}\bigl((\symA\symp - \symd)^{\mathrm T}(\symA\symp - \symd)\bigr) \end{aligned}$$`,
    check: 'Both sides for the net above: the sum over springs is {{sum}}, half k times the trace is {{trace}}.',
    inertia: raw`
Inertia becomes, with the masses on the diagonal of $\symM$ and $\mathbf{q} = \symp - 2\sympCurr + \sympPrev$,

$$\syminertia = \tfrac{1}{2\symdeltaT^2}\operatorname{tr}\bigl(\mathbf{q}^{\mathrm T}\symM\,\mathbf{q}\bigr).$$`,
  },
  collect: {
    title: 'Collect what multiplies p',
    text: raw`
Where a function is least, its gradient vanishes. The gradient of a trace of squares is as simple as that of a square: $\operatorname{tr}(\mathbf{X}^{\mathrm T}\mathbf{X})$ has $2\mathbf{X}$. Set the sum of all gradients to zero and put everything that multiplies $\symp$ on the left:

$$\begin{aligned} & \bigl(\symk\symA^{\mathrm T}\symA + \tfrac{1}{\symdeltaT^2}\symM + \symw\symC^{\mathrm T}\symC\bigr)\,\symp \\ & \quad = \symk\symA^{\mathrm T}\symd + \symy \end{aligned}$$

The bracket is $\symQ$, the right side $\symb$. What does not change while $\symp$ and $\symd$ take turns is gathered in $\symy$:

$$\begin{aligned} \symy = {} & \tfrac{1}{\symdeltaT^2}\symM\,(2\sympCurr - \sympPrev) \\ & + \symfExt + \symw\symC^{\mathrm T}\symC\,\sympTarget \end{aligned}$$

$$\symQ\symp = \symb$$

$\symC$ and $\symw$ belong to the pins; [section 9](pins) is about them.`,
    caption: 'Switch the terms of Q on and off. Which of them puts something beside the diagonal?',
    terms: 'Terms of Q',
    springs: 'springs',
    masses: 'masses',
    pins: 'pins',
  },
  constants: {
    ask: raw`Multiplied out, $\symsurrogate$ also has terms without $\symp$, such as $\tfrac12\symk\operatorname{tr}(\symd^{\mathrm T}\symd)$. Why does nobody bother to write them down?`,
    hint: raw`Lift a valley by ten metres. Where is its lowest point now?`,
    answer: raw`Because we look for the place of the lowest point, not for its height. A constant lifts the whole curve; its derivative is zero, so neither $\symQ$ nor $\symb$ knows of it. What is left is

$$\tfrac12\operatorname{tr}(\symp^{\mathrm T}\symQ\symp) - \operatorname{tr}(\symp^{\mathrm T}\symb)$$

The chart moves vertex 1 up and down, with $\symd$ held, and draws both.`,
    caption:
      'Step on, or pull at vertex 1: the curves change, their distance changes, their lowest point stays common.',
    whole: 'with constants',
    left: 'without',
    x: 'vertex 1, above where it is now, m',
    y: raw`$\symsurrogate$, J`,
    summary: 'Two parabolas, one exactly above the other.',
    difference: 'The constants come to {{difference}}, wherever vertex 1 is.',
  },
  changes: {
    ask: raw`You pull at a vertex. Which of $\symA$, $\symM$, $\symQ$, $\symp$, $\symd$ and $\symb$ change? And which when you change $\symk$?`,
    hint: raw`Look for $\symp$ in the definition of each.`,
    answer: raw`$\symA$, $\symM$ and $\symQ$ do not know where the vertices are now. $\symQ$ depends on the springs, $\symk$, the masses, $\symdeltaT$, the pinned set and $\symw$, and stays as it is from step to step; that is why it is worth factorising once. When you pull, $\symp$ changes, with it $\symd$ at the next local step, and with $\symd$ the right side $\symb$. When you change $\symk$, $\symQ$ and $\symb$ change at once, and $\symp$ and $\symd$ follow. Try both below.`,
    caption: 'What the last change changed is marked.',
    changed: 'changed',
    same: 'as it was',
  },
  laplacian: {
    ask: raw`What stands in row $i$ of $\symA^{\mathrm T}\symA$?`,
    hint: raw`Entry $(i, j)$ is the product of two columns of $\symA$: go through the springs and see where both have something.`,
    answer: raw`On the diagonal, how many springs vertex $i$ has: each contributes $(\pm1)^2$. Beside it, $-1$ for every vertex that a spring joins to $i$, and zero for all others. Rows add up to zero. In other fields the matrix is called the **graph Laplacian**. In the table of $\symQ$ above, with springs alone switched on, it is multiplied by $\symk$. Here it is for a net of nine:`,
    caption: 'Point at a number beside the table: its vertex lights up. Count its springs.',
  },
  columns: {
    ask: raw`Why three columns, and not one long vector with $3n$ entries for $n$ vertices?`,
    hint: raw`Does the $x$ of one vertex occur in the equation for the $y$ of another?`,
    answer: raw`With $\symd$ held, it does not: the three columns of $\symQ\symp = \symb$ are three systems with the same matrix. One factorisation serves all three, and the matrix is a third as wide. Newton’s method has no such luck: there $x$, $y$ and $z$ mix, and the matrix is $3n \times 3n$ and new in every iteration. Push at a vertex along one axis, and compare how both answer:`,
    caption: 'Push along x: the global step moves nothing along y. Let time pass: its answer stays, Newton’s changes.',
    push: 'Push vertex {{vertex}} with {{force}} N along',
    global: 'Global step, d held: how far each vertex moves, mm',
    newton: 'Newton’s step, mm',
  },
  sources: {
    jacobson:
      'A. Jacobson, Computer Graphics – Mass-Spring Systems (course text): “Matrices”, traces and the global step.',
    liu: 'T. Liu, A. Bargteil, J. O’Brien, L. Kavan, Fast Simulation of Mass-Spring Systems, 2013: section 4, where A and its Laplacian appear spring by spring.',
    boyd: 'S. Boyd, L. Vandenberghe, Introduction to Applied Linear Algebra: chapter 7, incidence matrices; chapter 12, least squares.',
  },
};
