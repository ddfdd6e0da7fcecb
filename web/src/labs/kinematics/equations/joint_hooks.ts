import { pointedJoint } from '../../../app/pointed_joint.ts';

/** The attributes of an element that stands for a joint: pointing at it lights the joint everywhere, and it is lit likewise. */
export function jointHooks(joint: number) {
  const leave = () => {
    if (pointedJoint.value === joint) pointedJoint.value = null;
  };
  const enter = () => {
    pointedJoint.value = joint;
  };
  return {
    'data-joint': joint,
    'data-joint-lit': pointedJoint.value === joint,
    onPointerEnter: enter,
    onPointerLeave: leave,
    onFocusCapture: enter,
    onBlurCapture: leave,
  };
}
