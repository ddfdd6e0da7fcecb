import { Icon, type IconName } from '../../lib/icon.tsx';

interface Props {
  icon: IconName;
  label: string;
  half?: boolean;
  off?: boolean;
  onClick: () => void;
}

export function StepButton({ icon, label, half = false, off = false, onClick }: Props) {
  return (
    <button type="button" aria-label={label} title={label} aria-disabled={off} onClick={off ? undefined : onClick}>
      <Icon name={icon} />
      {half && '½'}
    </button>
  );
}
