/** Texts of the equations beside the arm. */
export const en = {
  heading: 'Equations',
  none: '–',
  root: 'joint {{joint}}, the root',
  joint: 'joint {{joint}}',
  effector: 'joint {{joint}}, the end effector',
  errorChange: 'error {{before}} → {{after}}',
  forward: {
    heading: 'Forward kinematics',
    table: 'Place, length of the link and angle of every joint',
    oneJoint: 'Forward kinematics of joint {{joint}}, in metres',
    length: 'length',
    rotation: '= {{angle}} about {{axis}}',
    noRotation: 'does not turn',
    matrix: 'as a matrix',
    matrixOf: 'Rotation of joint {{joint}} against the world, 3 × 3',
  },
  method: {
    ccd: 'Cyclic coordinate descent',
    fabrik: 'FABRIK',
    'least-squares': 'Damped least squares',
  },
  ccd: {
    rot: 'rot(θ, a) is the rotation by θ about a; the transposed R takes the axis into the joint’s own frame.',
    axis: 'about {{axis}}',
    table: 'The two rays from joint {{joint}}, in metres',
    held: 'It turned by {{angle}}: its limit does not let it go further.',
    rounded:
      'It turned by {{angle}}: single precision takes the angle from its cosine, and that of a small angle rounds to 1.',
  },
  fabrik: {
    backward: 'backward pass',
    forward: 'forward pass',
    rotations: 'rotations from the positions',
    limit: 'held to the limits',
    moved: 'moved, {{unit}}',
    turned: 'turned',
    rootGap: 'The root is {{length}} from where it belongs; the forward pass puts it back.',
  },
  leastSquares: {
    axes: 'x̂, ŷ and ẑ are the axes of the world; JΔ is what the turns would do if they were small.',
    table: 'What is missing, what the turns promise, and what came of it',
    damping: '= {{lambda}}; its square is {{share}} of the squared error',
    unknownDamping: 'cannot be told from the turns: limits held them, nothing came nearer, or it is too small.',
    turns: 'Turns of the joints, in degrees',
    matrix: '3 × {{columns}}, in metres',
    matrixLabel: 'Jacobian matrix, three columns for each joint, in metres',
  },
  notes: {
    start: 'Nothing has turned yet: the search begins with this pose.',
    limit:
      'The positions asked for more than the joints may do. So from the root on, each joint points its link from where it is to where the next joint should have come, as far as its limit lets it.',
    within: 'No joint has gone beyond its limit, so all stay as they are.',
    straight:
      'No pose reaches the target, so there is nothing to search for: the arm is laid straight along the line from the root to the target, as near as it can come.',
    straightened:
      'No pose reaches the target, so there is nothing to search for: every joint turns towards the pose that lies straight along the line from the root to the target, at most by its limit.',
    bend: 'The arm lay on one line with the target. There every method turns by nothing or by half a turn, so each joint was bent a little first.',
  },
  outcomes: {
    converged: 'Converged: the end effector is within ε of the target.',
    held: 'Held by its limits: no joint may turn any further towards the target.',
    slowed: 'Held back: for one target the joints have turned as far as they may.',
    stalled: 'Stalled: nothing moves any more, although the target is within reach.',
    rounded: 'Stalled: single precision rounds the angles that are left to none, so nothing moves any more.',
    tooFar: 'Out of reach: the target is {{distance}} from the root, and the arm is {{farthest}} long.',
    tooNear:
      'Out of reach: the target is {{distance}} from the root, and the longest link keeps the end effector at least {{nearest}} away.',
    notYet: 'All {{iterations}} iterations are made, and the error is still larger than ε.',
  },
  result: {
    heading: 'Result of the search',
    error: 'error',
    iterations: 'iterations: {{made}} of at most {{most}}',
  },
  errors: {
    heading: 'Iteration by iteration',
    curve: 'distance',
    tolerance: 'ε, near enough',
    iteration: 'iteration',
    label: 'distance from end effector to target, mm',
    summary: 'The distance between end effector and target, from {{before}} to {{after}} in {{iterations}} iterations',
  },
};
