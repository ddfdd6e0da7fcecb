const { raw } = String;

export const en = {
  intro: raw`
Something has to hold the net, or it falls for ever. A **pinned** vertex stays at a target, or follows it when you drag. How do we tell the linear system?

The simplest way is a **penalty**: a very stiff spring of length zero between the vertex and its target. It adds one more square to the energy, with a weight $\symw$ that is much larger than $\symk$:

$$\sympinEnergy = \tfrac12 \symw \sum_{i\;\text{pinned}} \lVert \symp_i - \sympTarget_i \rVert^2$$

To write that without an index, let $\symC$ pick the pinned rows: a row for every pinned vertex with a single $1$ in its column, so that $\symC\symp$ are the positions of the pinned vertices and nothing else. The gradient adds $\symw\symC^{\mathrm T}\symC$ to the matrix and $\symw\symC^{\mathrm T}\symC\,\sympTarget$ to the right side.`,
  caption:
    'Change w. In Q a single entry moves: the diagonal of the pinned vertex. Drag the pin: Q does not change at all.',
  weak: {
    title: 'A penalty gives way',
    text: raw`
A spring that pulls with a force is longer than its rest length, and this one is no exception: the pin yields until its pull balances the rest of the net, by force over $\symw$. With $\symw = 10^{10}\,\text{N/m}$ that is about a millionth of a millimetre; with a small $\symw$ you can see it hang.

Why not take an even larger one? The factorisation would not mind: one huge number on the diagonal is merely scaling. What suffers is the pin’s own force, $\symw$ times a difference of two positions. A double holds 16 digits, so a position of about 1 m is rounded by $10^{-16}$ m, and the force, with it the gradient and the energy, is known to about $\symw \cdot 10^{-16}$ m and no better. Beyond some $\symw$ nobody can tell any more whether the iteration has arrived.`,
    drift: 'the pin has yielded by',
    force: 'force at the pin, w times that',
    rounding: 'and rounded by about',
  },
  elimination: {
    title: 'Or take them out',
    text: raw`
The other way is **elimination**. A pinned vertex is no unknown. Strike its row and its column out of $\symQ$; what its column would have multiplied is known, so it moves to the right side. The system is smaller, better conditioned, and the pin is held exactly. The price: a pin more or less is another matrix size, with another pattern, where the penalty only changes a number on the diagonal.

Left to itself the lab eliminates, because that is faster. As soon as you choose a $\symw$, it takes the penalty, so that you can see what it does.`,
    caption: 'The same triangle without w: what is left of Q, and what is struck out.',
    left: 'Q, rows and columns of pinned vertices struck out',
  },
  every: {
    ask: raw`Is the penalty added to every entry of $\symQ$, or to some rows?`,
    hint: raw`$\symC^{\mathrm T}\symC$: column $a$ of $\symC$ times column $b$. When is that not zero?`,
    answer: raw`To single entries: one on the diagonal for every pinned vertex. $\symC^{\mathrm T}\symC$ is zero but for a $1$ at $(i, i)$ where $i$ is pinned. On the right side only the rows of pinned vertices get something. The tables show both.`,
    caption: raw`$\symC$ has as many rows as there are pins; $\symC^{\mathrm T}\symC$ is as large as $\symQ$.`,
  },
  product: {
    ask: raw`$\symC$, $\symC^{\mathrm T}$ or $\symC^{\mathrm T}\symC$: how do you find out which belongs where, without looking it up?`,
    hint: raw`Write down the shapes.`,
    answer: raw`$\symC$ is #pinned × #V. It can stand left of something with #V rows ($\symC\symp$: pick), $\symC^{\mathrm T}$ left of something with #pinned rows ($\symC^{\mathrm T}$ of targets: put back where they belong). Only $\symC^{\mathrm T}\symC$ is #V × #V and can be added to $\symA^{\mathrm T}\symA$. If your targets are stored as a list of #pinned rows, the right side needs $\symw\symC^{\mathrm T}$ times the list. Multiply, and see what fits:`,
    caption: 'Of the six products three fit. Two have a row for every vertex, as Q p and b have: which is for which?',
    left: 'Left',
    right: 'Right',
    positions: 'p, a row for every vertex',
    list: 'targets, a row for every pin',
    fits: '{{rows}} × {{columns}} times {{others}} × 3 gives {{rows}} × 3: a row for every vertex, as in Q p = b.',
    small: '{{rows}} × {{columns}} times {{others}} × 3 gives {{rows}} × 3: the pinned rows alone.',
    misfit: '{{rows}} × {{columns}} times {{others}} × 3 does not fit: {{columns}} columns, but {{others}} rows.',
    result: 'The product, in m',
  },
  slip: {
    printed: raw`\begin{aligned} \sympinEnergy = {} & \tfrac{\symw}{2}\operatorname{tr}\bigl(\symp^{\mathrm T}\symC^{\mathrm T}\symC\symp\bigr) \\ & - \symw\operatorname{tr}\bigl(\symp^{\mathrm T}\sympTarget\bigr) \end{aligned}`,
    right: raw`\begin{aligned} \sympinEnergy = {} & \tfrac{\symw}{2}\operatorname{tr}\bigl(\symp^{\mathrm T}\symC^{\mathrm T}\symC\symp\bigr) \\ & - \symw\operatorname{tr}\bigl(\symp^{\mathrm T}\symC^{\mathrm T}\symC\,\sympTarget\bigr) \end{aligned}`,
    why: raw`One text writes the rest positions without $\symC^{\mathrm T}\symC$ before them. Then the penalty pulls at **every** vertex, towards its place at rest, with all of $\symw$, and nothing holds it back where $\symC^{\mathrm T}\symC$ is zero. (What is the same for all $\symp$ is left out of both lines.)`,
  },
  again: {
    ask: raw`When must $\symQ$ be factorised anew: when a pin is dragged, or when a vertex is pinned or let go?`,
    hint: raw`Where does $\sympTarget$ stand?`,
    answer: raw`Dragging changes the target, and that stands on the right side only: no. Pinning another vertex changes $\symC$, hence $\symQ$: yes. Drag below: however long you pull, the counter of $\symQ$ does not move.`,
    caption: 'Drag the pin (the square), and compare the counters.',
    q: raw`changes of $\symQ$`,
    b: raw`changes of $\symb$`,
  },
  sources: {
    jacobson: 'A. Jacobson, Computer Graphics – Mass-Spring Systems (course text): “Pinned Vertices”.',
    levin: 'D. Levin, Mass-Spring Systems on Three Dimensions (course text): fixed points by projection.',
    nocedal:
      'J. Nocedal, S. Wright, Numerical Optimization: chapter 15, elimination of variables; chapter 17, quadratic penalty.',
  },
};
