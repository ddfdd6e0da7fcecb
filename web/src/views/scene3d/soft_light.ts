/** Light from the sky and the ground, and a soft one that goes with the eye, so that no side of anything is ever black. In view space; for linear colours. */
export const softLight = /* glsl */ `
  vec3 softLight(vec3 normal) {
    const vec3 sky = vec3(0.541);
    const vec3 ground = vec3(0.299, 0.313, 0.341);
    const vec3 lamp = vec3(0.605);
    vec3 up = viewMatrix[1].xyz;
    vec3 toLamp = mat3(viewMatrix) * normalize(cameraPosition + vec3(0.0, 0.5 * length(cameraPosition), 0.0));
    return mix(ground, sky, 0.5 + 0.5 * dot(normal, up)) + lamp * max(0.0, dot(normal, toLamp));
  }
`;
