// SPDX-License-Identifier: MIT
/** Key to the colours and lines of a drawing, and its settings: dark or not, how much of the soils is seen through a field. */
import type { ComponentChildren } from "preact";
import { useEffect, useState } from "preact/hooks";

import { report } from "../state";
import { isDark, watchTheme } from "../viewer/theme";
import { describeStrength, findSoilColour } from "./ground";
import { findUsedWater } from "./standingWater";

export function useDark(): boolean {
  const [dark, setDark] = useState(isDark);
  useEffect(() => watchTheme(() => setDark(isDark())), []);
  return dark;
}

const usual = 0.72;

export function useOpacity(): { opacity: number; slider: preact.ComponentChildren } {
  const [opacity, setOpacity] = useState(usual);
  const slider = (
    <label>
      Field over soils
      <input
        type="range"
        min="0"
        max="1"
        step="0.04"
        value={opacity}
        onInput={(e) => setOpacity(e.currentTarget.valueAsNumber)}
      />
    </label>
  );
  return { opacity, slider };
}

export function LineSwatch({ colour, dash, width = 2.2 }: { colour: string; dash?: string; width?: number }) {
  return (
    <svg viewBox="0 0 28 12" width="28" height="12" aria-hidden="true">
      <line x1="1" x2="27" y1="6" y2="6" stroke={colour} stroke-width={width} stroke-dasharray={dash} />
    </svg>
  );
}

export function LineKey(props: { colour: string; dash?: string; width?: number; children: ComponentChildren }) {
  return (
    <li>
      <LineSwatch colour={props.colour} dash={props.dash} width={props.width} />
      {props.children}
    </li>
  );
}

/** Soils and water tables. */
export function GroundKeys() {
  const { polygons, surcharges, bars, crack } = report.value.model;
  const used = findUsedWater();
  const soils = [...new Set(polygons.map((p) => p.material).filter(Boolean))];
  return (
    <>
      {soils.map((name) => (
        <li key={name}>
          <svg viewBox="0 0 14 12" width="14" height="12" aria-hidden="true">
            <rect
              x="0.5"
              y="0.5"
              width="13"
              height="11"
              fill={findSoilColour(name)}
              fill-opacity="0.4"
              stroke="currentColor"
            />
          </svg>
          {name}
          {describeStrength(name) && <span class="muted"> {describeStrength(name)}</span>}
        </li>
      ))}
      {used && used.water_table.length > 0 && (
        <LineKey colour="#2f7fd6" dash="8 2 2 2" width={1.8}>
          Water table
        </LineKey>
      )}
      {used && used.ponds.length > 0 && (
        <LineKey colour="#2f7fd6" width={1.8}>
          Level of standing water
        </LineKey>
      )}
      {used && used.exits.length > 0 && <li>○ Exit of the seepage</li>}
      {surcharges.length > 0 && <li>↓ Surcharge</li>}
      {bars.length > 0 && (
        <LineKey colour="currentColor" width={2.2}>
          Support; thick: bonded part
        </LineKey>
      )}
      {crack && (
        <LineKey colour="currentColor" dash="3 2" width={2.2}>
          Tension crack{crack.water > 0 && ", blue: water in it"}
        </LineKey>
      )}
    </>
  );
}
