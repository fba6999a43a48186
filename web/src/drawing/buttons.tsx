// SPDX-License-Identifier: MIT
/** Buttons with a sign over a drawing, in an element of class icon-buttons. */
import "./buttons.css";

export function IconButton(props: { name: string; path: string; act: () => void; class?: string }) {
  const { name, path, act } = props;
  return (
    <button type="button" class={props.class} aria-label={name} title={name} onClick={act}>
      <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
        <path d={path} fill="none" stroke="currentColor" stroke-width="1.6" />
      </svg>
    </button>
  );
}

export function ZoomButtons(props: { zoom: (factor: number) => void; fit: () => void; class?: string }) {
  const buttons: [string, string, () => void][] = [
    ["Zoom in", "M8 3v10M3 8h10", () => props.zoom(1.4)],
    ["Zoom out", "M3 8h10", () => props.zoom(1 / 1.4)],
    ["Fit", "M2.5 6V2.5H6M10 2.5h3.5V6M13.5 10v3.5H10M6 13.5H2.5V10", props.fit],
  ];
  return (
    <>
      {buttons.map(([name, path, act]) => (
        <IconButton key={name} class={props.class} name={name} path={path} act={act} />
      ))}
    </>
  );
}
