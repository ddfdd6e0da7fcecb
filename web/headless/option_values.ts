import { UsageError } from './usage_error.ts';

export function positive(option: string, text: string): number {
  const value = Number(text);
  if (!(value > 0 && Number.isFinite(value))) throw new UsageError(`${option}: "${text}" is not a positive number`);
  return value;
}

export function notNegative(option: string, text: string): number {
  const value = Number(text);
  if (text.trim() === '' || !(value >= 0 && Number.isFinite(value)))
    throw new UsageError(`${option}: "${text}" is not 0 or a positive number`);
  return value;
}

/** Of the solver's whole numbers. */
const largestInt = 2 ** 31 - 1;

export function wholeNumber(option: string, text: string): number {
  const value = Number(text);
  if (!(value > 0 && Number.isSafeInteger(value)))
    throw new UsageError(`${option}: "${text}" is not a whole number from 1 on`);
  if (value > largestInt) throw new UsageError(`${option}: "${text}" is more than ${largestInt}`);
  return value;
}

export function oneOf<T extends string>(option: string, text: string, choices: readonly T[]): T {
  const choice = choices.find((known) => known === text);
  if (choice === undefined) throw new UsageError(`${option}: "${text}" is not one of ${choices.join(', ')}`);
  return choice;
}
