const { raw } = String;

export const en = {
  intro: raw`
A flag, a rope, a lump of jelly: all of them stretch, bend and swing. To compute that, we cut the body into **points** that carry all of its mass, and join neighbouring points by **springs** that carry none. This is a mass-spring system. It is a crude picture of matter, and a useful one: enough springs in the right places fold like cloth and wobble like jelly.

What a computer has to be told is short:

- $\symV$, one row for every point: its rest position, in metres. We call the points **vertices**.
- $\symE$, one row for every spring: the two vertices $i$ and $j$ that it joins.
- $\symm_i$, the mass of every vertex, in kilograms.
- $\symk$, how stiff the springs are, in newtons for every metre they are stretched.
- which vertices are **pinned**, held by a hand that does not yield.

The length of a spring in $\symV$ is its **rest length** $\symr_{ij} = \lVert \symV_i - \symV_j \rVert$: there it neither pulls nor pushes.`,
  caption:
    'Three vertices, three springs. Pull at a vertex and let go; choose a spring or a vertex and find its row in the tables.',
  spring: 'Spring {{spring}} joins {{i}} and {{j}}: rest length {{rest}}, now {{now}}.',
  vertex: 'Vertex {{vertex}} has a mass of {{mass}} and hangs on springs {{springs}}.',
  law: {
    title: 'One law for every vertex',
    text: raw`
Every vertex obeys Newton’s second law: mass times acceleration is the sum of the forces,

$$\symm_i\,\syma_i = \symf_i.$$

The forces on vertex $i$ are the pulls of its springs, which depend on where its neighbours are, and what comes from outside, $\symfExt_i$, here its weight $\symm_i\,\symg$. That a spring takes two vertices to make a force is what makes the problem hard: no vertex can be moved without asking its neighbours.

A system is **at rest** when the forces on every free vertex cancel and nothing moves. A net whose springs all have their rest length is at rest as long as nothing pulls it. Under gravity it sags until its springs, a little too long now, carry its weight: the figure above ends there if you let it play.`,
  },
  pulls: {
    ask: raw`A stretched spring joins $i$ and $j$. Which way is each of its ends pulled, and what does that say about the sum of all spring forces?`,
    hint: raw`A spring knows only the line between its ends. Could it push one end without pushing against the other?`,
    answer: raw`Each end is pulled towards the other, both equally hard. So the pulls of one spring cancel, and with them those of all springs: whatever you do to the net below, the last row stays zero. Springs pass momentum from vertex to vertex; they make none. Only gravity and the hand at the pin change the momentum of the whole.`,
    caption: 'What the springs pull at each vertex, and the sum of it. Pull at a vertex and watch.',
    table: 'Pull of the springs, N',
    vertex: 'vertex',
    sum: 'sum',
  },
  least: {
    ask: raw`Which of the five things in the list above does the net need to fall freely, with no spring ever stretched?`,
    hint: raw`How does the acceleration of a falling stone depend on its mass?`,
    answer: raw`Only $\symV$. Every vertex falls with $\symg$ whatever its mass, so distances stay as they are and no spring feels anything. The net below has no pin. Let it play: it falls, and its shape does not change.`,
    caption: 'No pin: every spring keeps its rest length.',
  },
  sources: {
    jacobson:
      'A. Jacobson, Computer Graphics – Mass-Spring Systems (course text): “Mass-Spring Systems”, points, springs and the graph that they make.',
    levin: 'D. Levin, Mass-Spring Systems on Three Dimensions (course text): particles and generalised coordinates.',
    witkin: 'A. Witkin, D. Baraff, Physically Based Modeling (course text): “Particle System Dynamics”.',
  },
};
