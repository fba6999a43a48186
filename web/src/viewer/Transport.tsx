// SPDX-License-Identifier: MIT
/** First, previous, play, next, last; the slider; the speed. */
import { frameIndex, sequence } from "../state";
import { countFrames, goTo, step, togglePlaying } from "./play";
import { playing, speed } from "./settings";
import { Choice } from "./Toolbar";

const icons = {
  first: "M4 3v10M13 3 6 8l7 5z",
  previous: "M12 3 4.5 8l7.5 5z",
  play: "M4.5 2.5v11L13.5 8z",
  pause: "M4 3h3v10H4zM9.5 3h3v10h-3z",
  next: "M4 3l7.5 5L4 13z",
  last: "M12 3v10M3 3l7 5-7 5z",
};

function IconButton(props: { name: string; icon: keyof typeof icons; act: () => void; off?: boolean }) {
  const { name, act, off } = props;
  return (
    <button type="button" class="viewer-icon" aria-label={name} title={name} disabled={off} onClick={act}>
      <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
        <path
          d={icons[props.icon]}
          fill="currentColor"
          stroke="currentColor"
          stroke-width="1.2"
          stroke-linejoin="round"
        />
      </svg>
    </button>
  );
}

export function Transport() {
  const count = countFrames();
  const index = Math.min(frameIndex.value, count - 1);
  const shownFrame = sequence.value?.frames[index];
  const jump = (to: number) => {
    playing.value = false;
    goTo(to);
  };
  return (
    <div class="viewer-transport">
      <span class="viewer-buttons">
        <IconButton name="First frame" icon="first" act={() => jump(0)} off={index <= 0} />
        <IconButton name="Previous frame" icon="previous" act={() => step(-1)} off={index <= 0} />
        <IconButton
          name={playing.value ? "Pause" : "Play"}
          icon={playing.value ? "pause" : "play"}
          act={togglePlaying}
          off={count < 2}
        />
        <IconButton name="Next frame" icon="next" act={() => step(1)} off={index >= count - 1} />
        <IconButton name="Last frame" icon="last" act={() => jump(count - 1)} off={index >= count - 1} />
      </span>
      <input
        type="range"
        aria-label="Frame"
        aria-valuetext={shownFrame ? `${index + 1} of ${count}: ${shownFrame.label}` : undefined}
        min="0"
        max={Math.max(0, count - 1)}
        step="1"
        value={index}
        onInput={(event) => jump(event.currentTarget.valueAsNumber)}
      />
      <output class="viewer-frame">
        <b>{shownFrame?.label}</b>
        <span>
          {index + 1} / {count}
        </span>
      </output>
      <Choice
        label="Speed"
        value={String(speed.value)}
        choose={(value) => (speed.value = Number(value))}
        items={[0.25, 0.5, 1, 2, 4].map((s) => [String(s), `${s}×`])}
      />
    </div>
  );
}
