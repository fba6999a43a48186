// SPDX-License-Identifier: MIT
/** Key to the lines and symbols in the section. */
import type { HydraulicCondition } from "../contract";
import { pickedPoint, report } from "../state";
import { writeCondition } from "../page/format";
import { writeNumber, writeUnit } from "./scale";
import { chooseSymbol, evaluateSeries } from "./symbols";
import { chooseLook } from "../drawing/surfaceLines";
import { inSpace, layers, listOtherSurfaces } from "./settings";
import { frame, shown } from "./shown";
import { hasNoValue } from "./sizes";
import { movedThreshold, slipSurfaces, strainRidge, waterTables } from "./tracedLines";
import { findUsedWater } from "../drawing/standingWater";

const symbols = {
  hatching: "M1 3h24M5 3 1 11M11 3l-4 8M17 3l-4 8M23 3l-4 8",
  dashes: "M1 3h24M5 3 3.5 6M2.5 8 1 11M14 3l-1.5 3M11.5 8 10 11M23 3l-1.5 3M20.5 8 19 11",
  rollers: "M1 2h24M1 11h24M10 6.5a3 3 0 1 1-6 0 3 3 0 1 1 6 0M22 6.5a3 3 0 1 1-6 0 3 3 0 1 1 6 0",
};

function Entry(props: { path: string; text: string; colour?: string; dash?: string; width?: number }) {
  return (
    <li>
      {props.path && (
        <svg viewBox="0 0 26 13" width="26" height="13" aria-hidden="true">
          <path
            d={props.path}
            fill="none"
            stroke={props.colour ?? "currentColor"}
            stroke-width={props.width ?? 1.1}
            stroke-dasharray={props.dash}
          />
        </svg>
      )}
      {props.text}
    </li>
  );
}

const hydraulicSymbols: { [condition: string]: string } = {
  total_head: "M1 6h24M9 0h8l-4 6zM10 9h6M12 11.5h2",
  rain: "M5 1v10M3 8l2 3 2-3M13 1v10M11 8l2 3 2-3M21 1v10M19 8l2 3 2-3",
  seepage_face: "M1 12h24M5 11V2M3 5l2-3 2 3M13 11V2M11 5l2-3 2 3M21 11V2M19 5l2-3 2 3",
  flux: "M1 12h24M7 1v10M5 8l2 3 2-3M19 1v10M17 8l2 3 2-3",
  no_flow: "M1 4.5h24M1 8.5h24",
  free_drainage: "M1 2h24M7 2v10M5 9l2 3 2-3M19 2v10M17 9l2 3 2-3",
};

/** "total head 10 m": what a condition is in the shown frame. */
function describeCondition(condition: HydraulicCondition, time: number): string {
  const value = evaluateSeries(condition, time);
  if (!condition.series || Number.isNaN(value)) return condition.title;
  return `${condition.title} ${writeCondition(condition, value)}`;
}

export function Legend() {
  const { model } = report.value;
  const on = layers.value;
  const supports = new Map<string, { path: string; on: string[] }>();
  for (const boundary of model.boundaries) {
    // A model in space has no lines of supports to draw: they are named only.
    const path = boundary.lines.length ? symbols[chooseSymbol(boundary.fix)] : "";
    const known = supports.get(boundary.text) ?? { path, on: [] };
    known.on.push(boundary.on);
    supports.set(boundary.text, known);
  }
  const time = shown.value?.sequence.frames[frame.value]?.time ?? 0;
  const bar = "M1 6.5h24";
  const { length } = report.value.units;
  const limit = `${writeNumber(movedThreshold.value / length.si)} ${writeUnit(length)}`;
  return (
    <ul class="viewer-legend" aria-label="Legend">
      {on.slip && slipSurfaces.value.length > 0 && (
        <Entry path={bar} colour="#c2185b" width={2.4} text={`Slip surface: above it soil moved over ${limit}`} />
      )}
      {on.otherSurfaces &&
        model.dimension === 2 &&
        listOtherSurfaces().filter((s) => s.shown).map((s) => {
          const { colour, dash } = chooseLook(s.look);
          return <Entry key={s.name} path={bar} colour={colour} dash={dash.join(" ")} width={2.2} text={s.text} />;
        })}
      {on.ridge && strainRidge.value.length > 0 && (
        <Entry path={bar} colour="#b35900" dash="6 3" width={2} text="Axis of the largest deviatoric strain" />
      )}
      {hasNoValue.value && <Entry path={bar} colour="#999999" width={8} text="No value in this frame" />}
      {on.outline && <Entry path={bar} dash="5 3" text="Original outline" />}
      {on.supports && model.bars.length > 0 && <Entry path={bar} width={2.2} text="Supports" />}
      {on.present && model.dimension === 2 && <Entry path={bar} width={1.6} text="Present outline" />}
      {on.path && pickedPoint.value !== null && shown.value && (
        <Entry path={bar} colour="var(--accent)" width={2} text="Path of the picked point" />
      )}
      {on.water && (waterTables.value ?? findUsedWater()?.water_table ?? []).length > 0 && (
        <Entry path={bar} colour="#2f7fd6" dash="8 2 2 2" width={1.8} text="Water table" />
      )}
      {on.startWater && waterTables.value && (findUsedWater()?.water_table.length ?? 0) > 0 && (
        <Entry path={bar} colour="#2f7fd6" dash="2 3" width={1.4} text="Water table at the start" />
      )}
      {on.boundaries &&
        [...supports].map(([text, support]) => (
          <Entry
            key={text}
            path={inSpace.value && support.path ? bar : support.path}
            text={`${support.on.join(", ")}: ${text}`}
          />
        ))}
      {on.hydraulics &&
        (report.value.water?.conditions ?? []).map((condition, i) => (
          <Entry
            key={`hydraulic ${i}`}
            path={condition.lines.length && !inSpace.value ? hydraulicSymbols[condition.condition] ?? bar : ""}
            colour="#2f7fd6"
            width={1.3}
            text={`${condition.on}: ${describeCondition(condition, time)}`}
          />
        ))}
    </ul>
  );
}
