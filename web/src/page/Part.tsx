// SPDX-License-Identifier: MIT
/** A part of the report: a section with an address; drawn when it comes near the screen; if it fails, a message replaces it; buttons that copy. */
import { signal } from "@preact/signals";
import { Component, type ComponentChildren } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";

async function copyText(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    // Older browsers give no clipboard to pages from a disk; selecting and copying still works there.
    const area = document.createElement("textarea");
    area.value = text;
    area.style.position = "fixed";
    area.style.opacity = "0";
    document.body.append(area);
    area.select();
    const done = document.execCommand("copy");
    area.remove();
    return done;
  }
}

export function CopyButton({ label, text }: { label: string; text: () => string }) {
  const [said, setSaid] = useState("");
  const copy = async () => {
    setSaid((await copyText(text())) ? "Copied" : "Copying is not allowed here");
    setTimeout(() => setSaid(""), 2500);
  };
  return (
    <span class="copy">
      <span class="said" role="status">
        {said}
      </span>
      <button type="button" onClick={copy}>
        {label}
      </button>
    </span>
  );
}

/** `what`: as in "The curve cannot be shown". */
export class Guard extends Component<{ what: string; children?: ComponentChildren }, { fault: string | null }> {
  state = { fault: null as string | null };

  componentDidCatch(error: unknown) {
    this.setState({ fault: error instanceof Error ? error.message : String(error) });
  }

  render() {
    if (this.state.fault === null) return <>{this.props.children}</>;
    return (
      <p class="fault" role="alert">
        {this.props.what} cannot be shown: {this.state.fault}. The other parts of the report are not affected.{" "}
        <button type="button" onClick={() => this.setState({ fault: null })}>
          Try again
        </button>
      </p>
    );
  }
}

/** Set once everything has to be there, whatever is on the screen. */
const everything = signal(false);
const waiting: (() => void)[] = [];
let idle = false;

const whenIdle: (action: () => void) => void =
  "requestIdleCallback" in globalThis
    ? (action) => requestIdleCallback(action, { timeout: 1500 })
    : (action) => setTimeout(action, 60);

/** Draws one part after the other, so that the page stays responsive; marks <html> when all are drawn. */
function drawNext() {
  const next = waiting.shift();
  if (next) {
    next();
    whenIdle(drawNext);
  } else {
    idle = false;
    document.documentElement.dataset.drawn = "all";
  }
}

function wait(draw: () => void) {
  delete document.documentElement.dataset.drawn;
  waiting.push(draw);
  if (idle) return;
  idle = true;
  setTimeout(() => whenIdle(drawNext), 400);
}

/** Draws all parts now: before printing. */
export function drawEverything() {
  everything.value = true;
}

/** `height` of the part before it is drawn [px], so that the page does not jump. */
export function Lazy({ height, children }: { height: number; children: () => ComponentChildren }) {
  const [drawn, setDrawn] = useState(false);
  const place = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const draw = () => setDrawn(true);
    wait(draw);
    const observer = new IntersectionObserver(
      (entries) => {
        if (entries.some((entry) => entry.isIntersecting)) draw();
      },
      { rootMargin: "500px" },
    );
    if (place.current) observer.observe(place.current);
    return () => observer.disconnect();
  }, []);
  if (drawn || everything.value) return <>{children()}</>;
  return <div ref={place} class="not-yet" style={{ minHeight: `${height}px` }} aria-busy="true" />;
}

interface Props {
  id: string;
  title: string;
  /** One sentence under the heading: what is seen here. */
  lead?: ComponentChildren;
  /** Starts on a new page when printed. */
  newPage?: boolean;
  /** Holds a chart section, which is a landmark with a name of its own; its heading would repeat it. */
  chart?: boolean;
  /** Buttons beside the heading; not printed. */
  tools?: ComponentChildren;
  children: ComponentChildren;
}

export function Part({ id, title, lead, newPage, chart, tools, children }: Props) {
  const names = ["part", newPage && "new-page", chart && "chart-part"].filter(Boolean).join(" ");
  return (
    <section id={id} class={names} aria-labelledby={chart ? undefined : `${id}-heading`} tabIndex={-1}>
      <div class="part-head">
        <h2 id={`${id}-heading`}>{title}</h2>
        {tools && <div class="tools no-print">{tools}</div>}
      </div>
      {lead && <p class="lead">{lead}</p>}
      {children}
    </section>
  );
}
