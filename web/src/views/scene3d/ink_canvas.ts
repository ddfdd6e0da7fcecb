import { type Scene, WebGLRenderer } from 'three';
import type { Rectangle } from '../../lib/rectangle.ts';
import { createInk, setInkColour } from './ink.ts';
import type { OrbitCamera } from './orbit_camera.ts';
import type { CanvasCallbacks } from './types.ts';

/** More device pixels than this in a CSS pixel cost without being seen. */
const mostPixelRatio = 2;

/** A canvas, what draws on it, and the ink that everything drawn on it shares. */
export class InkCanvas {
  readonly ink = createInk();
  private readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly stop = new AbortController();
  /** CSS pixels. Reading it from the canvas while drawing would make the browser lay out the page. */
  private size = { width: 0, height: 0 };

  constructor(canvas: HTMLCanvasElement, callbacks: Pick<CanvasCallbacks, 'onContextLost' | 'onInvalidate'>) {
    this.canvas = canvas;
    const context = canvas.getContext('webgl2', { antialias: true, alpha: false });
    if (!context) throw new Error('This browser gives no WebGL 2 context.');
    this.renderer = new WebGLRenderer({ canvas, context });
    this.renderer.autoClear = false;
    const { signal } = this.stop;
    canvas.addEventListener('webglcontextlost', () => callbacks.onContextLost(), { signal });
    canvas.addEventListener('webglcontextrestored', () => callbacks.onInvalidate(), { signal });
  }

  /** To be called whenever the canvas changes its size. */
  measure(): void {
    this.size = { width: this.canvas.clientWidth, height: this.canvas.clientHeight };
  }

  clear(background: string): void {
    this.followSize();
    this.renderer.setScissorTest(false);
    this.renderer.setClearColor(background);
    this.renderer.clear();
    setInkColour(this.ink.background.value, background);
  }

  /** Into a rectangle of the canvas, CSS pixels. `haloDepth`: see Ink. */
  draw(scene: Scene, orbitCamera: OrbitCamera, { x, y, width, height }: Rectangle, haloDepth: number): void {
    const bottom = this.size.height - y - height;
    this.renderer.setScissorTest(true);
    this.renderer.setViewport(x, bottom, width, height);
    this.renderer.setScissor(x, bottom, width, height);
    orbitCamera.setAspect(width / height);
    const pixelRatio = this.renderer.getPixelRatio();
    const { distance, sceneRadius } = orbitCamera;
    this.ink.viewport.value.set(width, height).multiplyScalar(pixelRatio);
    this.ink.pixelRatio.value = pixelRatio;
    this.ink.fadeFrom.value = distance;
    this.ink.fadeTo.value = distance + 3 * sceneRadius;
    this.ink.haloDepth.value = haloDepth;
    this.renderer.render(scene, orbitCamera.camera);
  }

  /** Of the canvas no other use can be made afterwards. */
  dispose(): void {
    this.stop.abort();
    this.renderer.dispose();
    this.renderer.forceContextLoss(); // a page has sixteen contexts or so, and rooms come and go faster than garbage is collected
  }

  /** Just before drawing, or the canvas would be seen empty: changing its size clears it. */
  private followSize(): void {
    const { width, height } = this.size;
    const pixelRatio = Math.min(window.devicePixelRatio, mostPixelRatio);
    const sized =
      this.canvas.width === Math.floor(width * pixelRatio) && this.canvas.height === Math.floor(height * pixelRatio);
    if (sized && pixelRatio === this.renderer.getPixelRatio()) return;
    this.renderer.setPixelRatio(pixelRatio);
    this.renderer.setSize(width, height, false);
  }
}
