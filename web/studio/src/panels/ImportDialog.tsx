// SPDX-License-Identifier: MIT
/** The dialog of an import: what becomes of the files, the options of `talus import`, and afterwards what was recognised. */
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";

import { addPoints, importCase, type ImportOptions, type Pending, pending, type Purpose, remarks, suggestBase } from "../imports/imports";
import { isChanged, setting } from "../session";
import * as state from "../state";

const purposes: Record<Purpose, string> = {
  ground: "Ground of this case, with layers below it",
  region: "Region of this case: below the points, or within them where they are closed",
  line: "Named line of this case",
  water: "Water table of this case",
  surface: "Slip surface of this case",
  case: "New case, read by the program (boreholes, several tables, units)",
};

interface OptionText {
  key: string;
  label: string;
  hint: string;
  choices?: string[];
  list?: boolean;
}

const optionsOf: Record<Pending["kind"], OptionText[]> = {
  drawing: [
    { key: "units", label: "Unit of length", hint: "as the drawing states", choices: ["m", "mm", "cm", "km", "ft", "in", "US_survey_foot"] },
    { key: "lines", label: "Lines are", hint: "bottoms of the soils of their layers", choices: ["bottoms", "tops"] },
    { key: "as", label: "Write as", hint: "regions where lines cross, else layers", choices: ["layers", "regions"] },
    { key: "layers", label: "Layers of the drawing", hint: "all; or names with commas between", list: true },
    { key: "base", label: "Level of the base [m]", hint: "below the lowest line" },
    { key: "snap", label: "Distance of gaps to close [m]", hint: "1e-4 of the section" },
  ],
  model: [{ key: "analysis", label: "SLOPE/W analysis", hint: "the first one" }],
  tables: [
    { key: "units", label: "Unit of length", hint: "as the headings state, else m", choices: ["m", "mm", "cm", "ft", "in"] },
    { key: "base", label: "Level of the base [m]", hint: "below the lowest point" },
    { key: "boreholes", label: "Boreholes", hint: "all; or names with commas between", list: true },
  ],
};

function OptionField({ option, values }: { option: OptionText; values: Record<string, string> }) {
  const { key, label, hint, choices } = option;
  const set = (value: string) => (values[key] = value);
  return (
    <label class="plain-field">
      {label}
      {choices ? (
        <select onChange={(e) => set(e.currentTarget.value)}>
          <option value="">{hint}</option>
          {choices.map((choice) => (
            <option key={choice}>{choice}</option>
          ))}
        </select>
      ) : (
        <input placeholder={hint} autocomplete="off" spellcheck={false} onInput={(e) => set(e.currentTarget.value)} />
      )}
    </label>
  );
}

function readOptions(known: readonly OptionText[], values: Record<string, string>): ImportOptions {
  const options: ImportOptions = {};
  for (const { key, list } of known) {
    const value = values[key]?.trim();
    if (value) options[key] = list ? value.split(",").map((part) => part.trim()).filter(Boolean) : value;
  }
  return options;
}

function ImportForm({ found, close }: { found: Pending; close: () => void }) {
  const points = found.table?.points ?? null;
  const hasProgram = setting.value?.workspace !== null;
  const possible = (Object.keys(purposes) as Purpose[]).filter((purpose) => (purpose === "case" ? hasProgram : points !== null));
  const hasRegions = state.chains.value.some(({ kind }) => kind === "region");
  const purpose = useSignal<Purpose>(points ? (hasRegions ? "region" : "ground") : "case");
  const base = useSignal(points ? String(suggestBase(points)) : "");
  const fault = useSignal("");
  const busy = useSignal(false);
  const values = useRef<Record<string, string>>({});
  const names = found.files.map(({ name }) => name).join(", ");
  const replaces = purpose.value === "case" && isChanged() && state.undoNames.value.length > 0;

  const accept = async () => {
    fault.value = "";
    if (purpose.value !== "case") {
      if (!points) return;
      if (addPoints(names, points, purpose.value, Number(base.value.replace("−", "-")))) {
        ++state.opened.value;
        state.notice.value = { text: `${points.length} points of ${names} are imported.`, bad: false };
        close();
      } else fault.value = state.notice.value?.text ?? "";
      return;
    }
    busy.value = true;
    try {
      await importCase(found.files, readOptions(optionsOf[found.kind], values.current));
      pending.value = null;
    } catch (error) {
      fault.value = error instanceof Error ? error.message : String(error);
    } finally {
      busy.value = false;
    }
  };

  const needsBase = purpose.value === "ground" || purpose.value === "region";
  return (
    <form
      method="dialog"
      onSubmit={(e) => {
        e.preventDefault();
        void accept();
      }}
    >
      <h2>Import {names}</h2>
      {points && (
        <p class="muted">
          {points.length} points, {found.table!.note}.
        </p>
      )}
      {found.table?.fault && <p class="muted">As a table of points it cannot be read: {found.table.fault}.</p>}
      {possible.length === 0 && (
        <p class="bad">The page in a browser alone reads tables of points and case files. Start talus studio for drawings, boreholes and GeoStudio files, or use talus import on the command line.</p>
      )}
      {possible.length > 1 && (
        <fieldset class="choices">
          <legend>What becomes of it?</legend>
          {possible.map((key) => (
            <label key={key}>
              <input type="radio" name="purpose" value={key} checked={purpose.value === key} onChange={() => (purpose.value = key)} />
              {purposes[key]}
            </label>
          ))}
        </fieldset>
      )}
      {needsBase && points && (
        <label class="plain-field">
          Level of the base of the section [m]
          <input value={base.value} inputMode="decimal" onInput={(e) => (base.value = e.currentTarget.value)} />
        </label>
      )}
      {purpose.value === "case" && hasProgram && optionsOf[found.kind].map((option) => <OptionField key={option.key} option={option} values={values.current} />)}
      {replaces && <p class="warn">The present case has changes that are not saved: they are discarded.</p>}
      {fault.value && (
        <p class="bad" role="alert">
          {fault.value}
        </p>
      )}
      <p class="tools">
        <button type="submit" disabled={busy.value || possible.length === 0}>
          {busy.value ? "Reading …" : "Import"}
        </button>
        <button type="button" onClick={close}>
          Cancel
        </button>
      </p>
    </form>
  );
}

function Recognised({ close }: { close: () => void }) {
  return (
    <>
      <h2>Imported</h2>
      <ul class="remarks">
        {remarks.value!.map((remark) => (
          <li key={remark}>{remark}</li>
        ))}
      </ul>
      <p class="tools">
        <button type="button" onClick={close}>
          Close
        </button>
      </p>
    </>
  );
}

export function ImportDialog() {
  const host = useRef<HTMLDialogElement>(null);
  const isOpen = pending.value !== null || remarks.value !== null;
  useEffect(() => {
    if (isOpen && !host.current!.open) host.current!.showModal();
  }, [isOpen]);
  if (!isOpen) return null;
  const close = () => {
    pending.value = null;
    remarks.value = null;
    document.querySelector<SVGSVGElement>("svg.section")?.focus();
  };
  return (
    <dialog ref={host} class="import-dialog" aria-label="Import" onClose={close}>
      {pending.value ? <ImportForm key={pending.value.files.map(({ name }) => name).join()} found={pending.value} close={close} /> : <Recognised close={close} />}
    </dialog>
  );
}
