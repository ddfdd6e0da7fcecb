const { raw } = String;

export const en = {
  intro: raw`
A spring that is stretched has taken in work, and gives it back when it is let go. How much it holds is its **potential energy**. For a spring after Hooke it grows with the square of the stretch:

$$\tfrac12\,\symk\,\bigl(\lVert \symp_i - \symp_j \rVert - \symr_{ij}\bigr)^2$$

Only the difference to the rest length counts. A spring 1 cm too short holds as much as one 1 cm too long. The energies of all springs add up to that of the net:

$$\sympotential = \sum_{ij} \tfrac12\,\symk\,\bigl(\lVert \symp_i - \symp_j \rVert - \symr_{ij}\bigr)^2$$`,
  force: {
    title: 'From energy to force',
    text: raw`
The springs pull where the energy falls fastest: the force is **minus** the gradient. Differentiating the length $\lVert \symp_i - \symp_j \rVert$ with respect to $\symp_i$ gives the unit vector from $j$ to $i$; so at the end $i$

$$\begin{aligned} & -\frac{\partial \sympotential}{\partial \symp_i} \\ & \quad = -\,\symk\,\underbrace{\bigl(\lVert \symp_i - \symp_j \rVert - \symr_{ij}\bigr)}_{\text{too long by}}\;\underbrace{\frac{\symp_i - \symp_j}{\lVert \symp_i - \symp_j \rVert}}_{\text{direction}} \end{aligned}$$

and at $j$ the same with the other sign. Size: $\symk$ newtons for every metre. Direction: along the spring, towards the other end if it is too long, away from it if it is too short.`,
  },
  closest: {
    title: 'The closest vector',
    text: raw`
There is a second way to read this energy, and the whole method grows out of it. Of all vectors $\symd$ of length $\symr$ – the circle in the figure, in space a sphere – look for the one closest to $\symp_i - \symp_j$. It points the same way, and what is missing between the two is just the stretch:

$$\bigl(\lVert \symp_i - \symp_j \rVert - \symr_{ij}\bigr)^2 = \min_{\lVert \symd \rVert = \symr_{ij}} \lVert (\symp_i - \symp_j) - \symd \rVert^2$$

A length with its root has become a distance between two vectors. [Section 5](trick) puts that to use.`,
    caption:
      'Pull vertex 1. The circle holds all vectors of the rest length; the thick one is the closest, and the dashed gap is the stretch.',
    length: 'length',
    rest: 'rest length',
    gap: 'gap',
    fromGap: '½k · gap²',
    fromSolver: 'energy, from the solver',
  },
  collapsed: raw`
What if both ends meet? Then every vector on the circle is equally close, and the spring has no direction to push in. The solver keeps a fixed one, so that the result is always the same and never “not a number”.`,
  quadratic: {
    ask: raw`The formula is a square. So is the energy a quadratic function of $\symp$, a parabola?`,
    hint: raw`Slide one end of a spring along a line through the other end, and out again on the far side. At how many places is the energy zero?`,
    answer: raw`No. The energy is zero on **both** sides, at $\symr$ to the left and to the right, with a peak in between where the ends meet. A parabola has one lowest point. Hold the closest vector $\symd$ fixed instead and a true parabola is left, $\tfrac12\symk\lVert(\symp_i-\symp_j)-\symd\rVert^2$: on one side it is the energy itself, on the other it lies above.`,
    summary:
      'Two curves over the place of one end. The energy of the spring has two lowest points and a peak between them; the parabola for fixed d is the same curve on the right side and lies above it on the left.',
    x: raw`$\symp_i - \symp_j$ along the line, m`,
    y: raw`energy, J`,
    energy: 'spring',
    parabola: 'd held fixed',
    caption:
      'Pull vertex 1 through vertex 0 to its other side: the line in the chart stands at the length of the spring. Change k: both curves grow with it.',
  },
  sign: {
    ask: raw`Your net flies apart as soon as you touch it. You are sure of the formula. Which sign would you look at first?`,
    hint: raw`The gradient points where the energy grows.`,
    answer: raw`A force that is **plus** the gradient pushes a long spring longer: every stretch feeds itself. You can find such a slip without thinking: nudge one vertex by $\pm 10^{-5}$ m, see how the energy changes, divide. The table does it for vertex 1 while you pull.`,
    caption: 'Pull vertex 1 and compare.',
    table: 'At vertex 1, N',
    formula: 'force by the formula',
    differences: 'minus differences of the energy',
    wrong: 'plus differences of the energy',
  },
  sources: {
    jacobson:
      'A. Jacobson, Computer Graphics – Mass-Spring Systems (course text): “Mass-Spring Systems”, potential energy and force; “Time integration as energy optimization”, the closest vector.',
    liu: 'T. Liu, A. Bargteil, J. O’Brien, L. Kavan, Fast Simulation of Mass-Spring Systems, 2013: section 4, the lemma on Hooke’s law.',
    nocedal: 'J. Nocedal, S. Wright, Numerical Optimization: chapter 8, finite differences.',
  },
};
