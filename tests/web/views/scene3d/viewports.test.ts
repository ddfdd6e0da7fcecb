import { describe, expect, it } from 'vitest';
import { Viewports } from '../../../../web/src/views/scene3d/viewports.ts';

const left = { x: 0, y: 10, width: 200, height: 100 };
const right = { x: 200, y: 10, width: 300, height: 200 };

const local = { name: 'local', rectangle: left };
const global = { name: 'global', rectangle: right };

describe('Viewports', () => {
  it('finds the view at a place; a shared edge belongs to one of them', () => {
    const viewports = new Viewports([local, global]);
    expect(viewports.at(199, 50)?.name).toBe('local');
    expect(viewports.at(200, 50)?.name).toBe('global');
    expect(viewports.at(100, 5)).toBeUndefined();
    expect(viewports.at(100, 110)).toBeUndefined();
  });

  it('shows nothing that has no area', () => {
    expect(new Viewports([global]).shown.map(({ name }) => name)).toEqual(['global']);
    expect(new Viewports([{ name: 'local', rectangle: { ...left, height: 0 } }]).shown).toEqual([]);
    expect(new Viewports([global]).named('local')).toBeUndefined();
  });

  it('knows the narrowest and the tallest', () => {
    const viewports = new Viewports([local, global]);
    expect(viewports.narrowestAspect).toBe(1.5);
    expect(viewports.height).toBe(200);
  });
});
