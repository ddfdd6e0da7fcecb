const { raw } = String;

export const en = {
  intro: raw`Newton’s law $\symf = \symM\syma$ speaks of acceleration, which is defined at every instant. A computer animation, like a
film, consists of single pictures, its **frames**. Between one picture and the next, $\symdeltaT$ later, nothing is stored. So velocity and acceleration
have to be made of what is there: **positions**.`,
  differences: {
    title: 'Differences in place of derivatives',
    velocity: raw`The velocity of vertex $i$ is the distance it has moved since the previous picture, divided by the time that this took:

$$\symvelocity_i \approx \frac{\sympCurr_i - \sympPrev_i}{\symdeltaT}$$

Acceleration is to velocity what velocity is to position. The velocity of the coming step, minus that of the last one, divided by
$\symdeltaT$:`,
    roles: raw`Three moments meet in this fraction, and they do not play the same part:

- $\sympPrev$ and $\sympCurr$, one step ago and now, are **known**;
- $\symp$, short for $\mathbf{p}^{t+\Delta t}$, is the **unknown** that a time step computes.

Afterwards everything moves up by one place: $\sympCurr$ becomes $\sympPrev$, $\symp$ becomes $\sympCurr$, and the next step begins.
No velocity needs to be stored. A scene that starts at rest begins with $\sympPrev = \sympCurr$.`,
  },
  swing: {
    caption: raw`A vertex on a spring. Rings: the known $\sympPrev$ and $\sympCurr$. With no force on it, it would go on along the dashed line, just as
far again. The arrow is what the forces add to that, $\symdeltaT^2\syma$, and its tip is $\symp$. Step with the last button of the row, change
$\symdeltaT$, pull at the vertex.`,
    table: 'Vertex 1, from its three positions',
  },
  size: {
    title: 'How long is a time step?',
    ask: raw`What is a sensible value of $\symdeltaT$?`,
    hint: raw`How many pictures a second does a film show? And the screen that you are looking at?`,
    answer: raw`As long as one picture is shown. Films have 24 pictures a second, so animation studios think in steps of 1/24 s. Most screens
refresh 60 times a second; a game that wants smooth motion takes 1/60 s, or 1/30 s to save work.

Longer steps cost less and show less: with 1 s, a whole swing falls between two pictures. There is a second price. Without friction, a triangle on a
nail would swing for ever. Let the four run and watch their energy, kinetic and potential together.`,
    seen: raw`All four lose energy although nothing in the model rubs, and **the longer the step, the more of it**. This method takes the forces
from the end of the step, which always brakes a little. Taking them from its beginning can do the opposite, and that ends worse, as the
[next section](optimisation) shows.`,
    order:
      'By how much a shorter step is better: the order of accuracy of every method, further down in the integrators lab',
    name: 'Δt = {{delta_t}}',
    reading: 't = {{time}}\nenergy {{gained}}',
    energy: raw`Change of energy since the start, J`,
    time: 'Simulated time, s',
    summary:
      'Energy over simulated time with four lengths of the time step. All curves fall, those of longer steps further.',
  },
  sources: {
    jacobson:
      'A. Jacobson, Computer Graphics – Mass-Spring Systems (course text): “Mass-Spring Systems”, up to the differences for the acceleration.',
    liu: 'T. Liu, A. Bargteil, J. O’Brien, L. Kavan, Fast Simulation of Mass-Spring Systems, 2013: section 3.',
    hairer:
      'E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration: chapter I, what methods do to the energy.',
  },
};
