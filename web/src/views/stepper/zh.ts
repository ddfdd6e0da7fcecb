import type { Catalogue } from '../../app/messages/index.ts';
import type { en } from './en.ts';

export const zh: Catalogue<typeof en> = {
  first: '回到开头',
  back: '后退一步',
  forward: '前进一步',
};
