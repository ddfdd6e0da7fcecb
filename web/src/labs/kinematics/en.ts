/** The kinematics lab's own texts. */
export const en = {
  title: 'Inverse kinematics',
  intro:
    'An arm of joints and links. Forward kinematics says where its end is once every joint has turned; inverse kinematics asks the other way round: how must the joints turn for the end to be here?',
  opening: 'The arm is being prepared…',
};
