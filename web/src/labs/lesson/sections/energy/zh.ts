import type { Catalogue } from '../../../../app/messages/index.ts';
import type { en } from './en.ts';

export const zh: Catalogue<typeof en> = {
  intro: '本节正在编写。',
};
