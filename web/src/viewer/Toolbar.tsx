// SPDX-License-Identifier: MIT
/** Selects sequence and field; settings that are needed less often are in menus. */
import { fieldName, report, sequenceIndex } from "../state";
import { Choice } from "./Choice";
import { ColourMenu } from "./ColourMenu";
import { CutMenu } from "./CutMenu";
import { writeTitle } from "./format";
import { LayerMenu } from "./LayerMenu";
import { showSequence } from "./play";
import { inSpace, limitMode } from "./settings";
import { field, fields } from "./shown";
import type { Stage } from "./stage";

function chooseField(name: string): void {
  if (limitMode.value === "hand") limitMode.value = "all";
  fieldName.value = name;
}

export function Toolbar(props: { stage: Stage | null; save: () => void }) {
  const { sequences, model } = report.value;
  return (
    <div class="viewer-toolbar">
      <Choice
        label="Sequence"
        value={String(sequenceIndex.value)}
        choose={(value) => showSequence(Number(value))}
        items={sequences.map((s, i) => [String(i), s.title])}
      />
      <Choice
        label="Field"
        value={field.value?.name ?? ""}
        choose={chooseField}
        items={fields.value.map((f) => [f.name, writeTitle(f.title, f.unit)])}
      />
      <span class="viewer-tools">
        <ColourMenu />
        <LayerMenu />
        <CutMenu stage={props.stage} />
        {model.dimension === 2 && (
          <button type="button" aria-pressed={inSpace.value} onClick={() => (inSpace.value = !inSpace.value)}>
            3D
          </button>
        )}
        <button type="button" aria-label="Save picture" title="Save picture" onClick={props.save}>
          Save
        </button>
      </span>
    </div>
  );
}
