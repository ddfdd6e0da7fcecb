const { raw } = String;

export const en = {
  intro: raw`
    [The last section](optimisation) made a time step a search: of all positions $\symp$, find those where
    $\symobjective$ is least. Nearly everything in it is harmless: constants, straight lines and parabolas in
    $\symp$. One thing is not, the length $\lVert \symp_i - \symp_j \rVert$ inside the energy of a spring. The root in
    it makes the problem non-linear.

    The trick does not remove the length. It hands it to a helper. Give every spring a vector $\symd_{ij}$ whose length
    is $\symr_{ij}$ and whose direction is free. One such vector is nearest to the spring, and how far off it is says
    how far the spring is stretched:

    $$\begin{aligned} &\bigl(\lVert \symp_i - \symp_j \rVert - \symr_{ij}\bigr)^2 \\ &\qquad = \min_{\lVert \symd_{ij} \rVert = \symr_{ij}} \lVert (\symp_i - \symp_j) - \symd_{ij} \rVert^2 \end{aligned}$$

    [Section 2](energy) has the picture of it. With the minimum pulled out in front, the time step looks for positions
    **and** helpers:

    $$\begin{aligned} \symobjective &= \min_{\symd} \symsurrogate \\ \symsurrogate &= \sum_{ij} \tfrac12 \symk \lVert (\symp_i - \symp_j) - \symd_{ij} \rVert^2 + \dots \end{aligned}$$

    The dots are inertia, forces and pins, as before. We have more unknowns now, and less to do: each kind alone is easy.
  `,
  halves: {
    title: 'Two easy halves',
    text: raw`
      **Local.** Hold $\symp$. No spring’s helper occurs in the term of another, so every spring finds its own, by a
      formula:

      $$\symd_{ij} = \symr_{ij}\,\frac{\symp_i - \symp_j}{\lVert \symp_i - \symp_j \rVert}$$

      **Global.** Hold $\symd$. Now $\symsurrogate$ is a parabola in $\symp$. It is lowest where its derivative vanishes,
      and that is a linear system, with the same matrix every time:

      $$\symQ\symp = \symb, \qquad \symb = \symk\symA^{\mathrm T}\symd + \symy$$

      Then local again, with the new $\symp$. Both together are one **iteration**, or round. Neither half can raise $\symsurrogate$: each picks the best of what it may
      choose, and to stay is one of the choices. Right after a local step $\symsurrogate = \symobjective$. So
      $\symobjective$ falls from round to round, or has arrived.
    `,
    caption: raw`Go on by half-steps. The local step shows in “Every spring alone”: each takes its rest length along its present direction, and the net tears. The global step shows in “All springs together”: one solve stitches it together; arrows show what moved. Pull at a vertex, then step again.`,
  },
  loops: {
    ask: raw`After the global step we go back to the local one. Has time gone on?`,
    hint: raw`There are two loops, one inside the other. Which quantities have a $t$ in their name?`,
    answer: raw`
      No. The outer loop is time: each of its turns looks for one new $\symp$. The inner loop only improves the guess.
      All that is known at the beginning, $\sympCurr$, $\sympPrev$ and so $\symy$, stands still in it. A local step makes
      $\symd$ new, and $\symb$ with it; a global step makes $\symp$ new. Only at “accept” does $\symp$ become the next
      $\sympCurr$.

      Step, and see which rows change:
    `,
    caption: raw`The chosen spring and vertex, in numbers. A bar marks what this half-step changed.`,
    changed: 'changed',
  },
  peanut: {
    ask: raw`A net sinks as if through peanut butter, though every formula in the program is right. What is too small?`,
    hint: raw`How far does a single round move a vertex?`,
    answer: raw`
      The number of rounds $K$. Every time step starts its search at $\sympCurr$, and every global step pulls towards
      springs that still point where they did. A few rounds go part of the way, and what is left undone acts like drag:
      the more so, the larger $\symk$ is.

      The same happens if $\symd$ is computed before the inner loop instead of in it. The second round then solves the
      first one’s system again and finds the first one’s answer: fifty rounds are worth one.
    `,
    height: raw`height of vertex 7, m`,
    time: raw`time, s`,
    rounds: 'K = {{iterations}}',
    summary:
      'With K = 1 the lowest vertex of the patch creeps down; with more rounds it drops, swings and comes to rest.',
  },
  stop: {
    title: 'When to stop',
    text: raw`
      The exact minimum takes endlessly many rounds, and nobody needs it. Three rules are common.

      - After a **fixed number** of rounds. One then knows what a picture costs, but not how exact it is.
      - Once the **gradient** is small. Its largest component is the force, in newtons, that is left unbalanced at the
        worst vertex; at zero, $f = ma$ holds exactly.
      - Once a round **lowers $\symobjective$ by little**. That is cheap to ask, but slow progress need not mean arrival.

      The course takes the first, with fifty rounds. The lab shows where [each rule stops each method](springs/convergence).
    `,
    caption: raw`The chart shows this one time step. Choose a rule and see after which round it ends.`,
    curve: 'the worst vertex',
    rounds: 'round',
    force: raw`largest component of $\symgradient$, N`,
    summary: 'On a logarithmic axis the unbalanced force falls along a nearly straight line, round by round.',
    tolerance: raw`$\varepsilon$ is {{gradient}} for the gradient, {{decrease}} for the decrease.`,
  },
  enough: {
    ask: raw`How many rounds are enough for the patch? And if its springs were four times as stiff?`,
    hint: raw`The curve is nearly straight, and its axis logarithmic. What does that say about two rounds in a row?`,
    answer: raw`
      Every round leaves about the same fraction of the gap. The fraction depends on $\symkappa$, which weighs springs
      against inertia within one time step: stiffer springs, a longer $\symdeltaT$ or lighter vertices bring it closer
      to 1. So there is no number that is always enough. Yet the rounds grow more slowly than $\symkappa$ itself: four
      times as stiff takes about two to two and a half times as many. These are the rounds until no vertex has more than
      {{tolerance}} unbalanced:
    `,
    kappa: raw`stiffness number $\symkappa$`,
    rounds: 'rounds needed',
    series: 'patch, eighth time step',
    summary: 'The rounds needed grow with the stiffness number, though more slowly than the number itself.',
  },
  sources: {
    jacobson:
      'A. Jacobson, Computer Graphics – Mass-Spring Systems (course text): “Time integration as energy optimization”, the helper d, both steps, fifty iterations.',
    liu: 'T. Liu, A. Bargteil, J. O’Brien, L. Kavan, Fast Simulation of Mass-Spring Systems, 2013: the method, and its convergence beside that of Newton’s.',
    nocedal:
      'J. Nocedal, S. Wright, Numerical Optimization: section 9.3, minimising in one group of variables after the other.',
  },
};
