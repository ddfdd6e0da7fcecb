import { describe, expect, it } from 'vitest';
import { Viewports } from '../../../../web/src/views/scene3d/viewports.ts';

const left = { x: 0, y: 10, width: 200, height: 100 };
const right = { x: 200, y: 10, width: 300, height: 200 };

describe('Viewports', () => {
  it('finds the view at a place; a shared edge belongs to one of them', () => {
    const viewports = new Viewports(left, right);
    expect(viewports.at(199, 50)?.name).toBe('local');
    expect(viewports.at(200, 50)?.name).toBe('global');
    expect(viewports.at(100, 5)).toBeUndefined();
    expect(viewports.at(100, 110)).toBeUndefined();
  });

  it('shows neither what is hidden nor what has no area', () => {
    expect(new Viewports(null, right).shown.map(({ name }) => name)).toEqual(['global']);
    expect(new Viewports({ ...left, height: 0 }, null).shown).toEqual([]);
    expect(new Viewports(null, right).named('local')).toBeUndefined();
  });

  it('knows the narrowest and the tallest', () => {
    const viewports = new Viewports(left, right);
    expect(viewports.narrowestAspect).toBe(1.5);
    expect(viewports.height).toBe(200);
  });
});
