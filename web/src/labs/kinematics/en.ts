/** The kinematics lab's own texts. */
export const en = {
  title: 'Inverse kinematics',
  intro:
    'An arm of joints and links; its tip is called the end effector. Forward kinematics says where the end effector is once every joint has turned. Inverse kinematics asks the other way round: how must the joints turn for it to be here?',
  opening: 'The arm is being prepared…',
};
