// SPDX-License-Identifier: MIT
/** The tools of the canvas: names, keys, hints, icons, and how many points they take. */
import type { Tool } from "../state";

export interface ToolText {
  title: string;
  key: string;
  /** Points after which it is finished; Infinity: by Enter or a double click. */
  points: number;
  hint: string;
  /** Path of an icon of 16 by 16. */
  icon: string;
  /** In the list of further tools. */
  further?: boolean;
}

export const tools: Record<Tool, ToolText> = {
  select: {
    title: "Select and move",
    key: "v",
    points: 0,
    hint: "Drag a vertex or a side. Shift: the whole line. Alt: without snapping.",
    icon: "M3.5 2l9 5.5-4 .8 2 4-1.6.8-2-4.1-3 2.8z",
  },
  region: {
    title: "Draw a region",
    key: "r",
    points: Infinity,
    hint: "Click corners, or type x,y, @dx,dy or length<angle. Enter, or a click on the first corner, closes it.",
    icon: "M2 13V9l4-1 3-5h5v10zM2 13h12",
  },
  split: {
    title: "Split by a line",
    key: "s",
    points: Infinity,
    hint: "Draw a line from side to side of a region, or across a selected line; Enter splits it.",
    icon: "M2.5 3.5h11v9h-11zM1 10c4 0 6-5 14-5",
  },
  insert: {
    title: "Insert a vertex",
    key: "i",
    points: 1,
    hint: "Click on a side.",
    icon: "M2 12L14 4M8 1v5M5.5 3.5h5M6.5 9a1.6 1.6 0 103-1 1.6 1.6 0 10-3 1",
  },
  water: {
    title: "Water table",
    key: "w",
    points: Infinity,
    hint: "Click points from left to right; Enter finishes. It is level beyond its ends.",
    icon: "M1.5 9c4 0 5 3 13 3M5 3h6L8 7.5z",
  },
  load: {
    title: "Surcharge",
    key: "l",
    points: 2,
    hint: "Click where it begins and where it ends along x; its value is in the form.",
    icon: "M2 13h12M2.5 3h11M4 3v8M2.5 9L4 11l1.5-2M12 3v8M10.5 9l1.500 2 1.500-2M8 3v8M6.500 9L8 11l1.500-2",
  },
  nail: {
    title: "Nail",
    key: "n",
    points: 2,
    hint: "Click its head on the ground, then its tip. Strengths and spacing are in the form.",
    icon: "M4 3l2 4 8 4M3 7.500l3.500-1",
  },
  line: {
    title: "Named line",
    key: "g",
    points: Infinity,
    hint: "Click points; Enter finishes. Boundary conditions and tractions refer to it by its name.",
    icon: "M2 12l4-6 4 3 4-6",
  },
  surface: {
    title: "Slip surface of your own",
    key: "u",
    points: Infinity,
    hint: "Click points from ground to ground; Enter finishes.",
    icon: "M2 3c1 7 6 9 12 9M2 3h3M11 12h3",
  },
  measure: {
    title: "Measure",
    key: "m",
    points: 2,
    hint: "Click two points: distance, differences and inclination are in the bar below.",
    icon: "M1.500 11.500l10-10 3 3-10 10zM5 8l1.500 1.500M7.500 5.500L9 7M10 3l1.500 1.500",
  },
  circle: {
    title: "Slip circle",
    key: "o",
    points: 2,
    hint: "Click its centre, then a point on it.",
    icon: "M8 2.500v.01M2 7a6.500 6.500 0 0012 0M8 2.500l4.500 7.500",
    further: true,
  },
  entry: {
    title: "Entry range of slip surfaces",
    key: "e",
    points: 2,
    hint: "Click from where to where on the crest slip surfaces begin.",
    icon: "M2 5h8l4 7M3 2.500h6M4.500 1v3M7.500 1v3",
    further: true,
  },
  exit: {
    title: "Exit range of slip surfaces",
    key: "x",
    points: 2,
    hint: "Click from where to where at the toe slip surfaces end.",
    icon: "M2 4l4 7h8M7 8.500h6M8.500 7v3M11.500 7v3",
    further: true,
  },
  window: {
    title: "Window of block search",
    key: "b",
    points: 2,
    hint: "Click two opposite corners; every surface has a vertex in each window.",
    icon: "M3 5h10v6H3zM1 3l5 5 4 1 5-4",
    further: true,
  },
  through: {
    title: "Line that surfaces cross",
    key: "t",
    points: Infinity,
    hint: "Click points; Enter finishes. Every slip surface cuts this line.",
    icon: "M8 2v12M2 5c2 5 6 6 12 6",
    further: true,
  },
  exclude: {
    title: "Excluded area",
    key: "a",
    points: Infinity,
    hint: "Click corners; Enter, or a click on the first corner, closes it. No slip surface enters it.",
    icon: "M3 4h10v8H3zM3 12L13 4",
    further: true,
  },
  centres: {
    title: "Grid of centres",
    key: "c",
    points: 2,
    hint: "Click two opposite corners of the grid of centres.",
    icon: "M3 3v.01M8 3v.01M13 3v.01M3 8v.01M8 8v.01M13 8v.01M3 13v.01M8 13v.01M13 13v.01M1.500 1.500h13v13h-13z",
    further: true,
  },
  tangent: {
    title: "Tangent levels",
    key: "y",
    points: 2,
    hint: "Click the lowest and the highest level of the deepest points of circles.",
    icon: "M2 12h12M2 9h12M3 3c2 8 8 8 10 0",
    further: true,
  },
  monitor: {
    title: "Monitor",
    key: "p",
    points: 1,
    hint: "Click a point whose history is written.",
    icon: "M8 2v12M2 8h12M5.500 8a2.500 2.500 0 105 0 2.500 2.500 0 10-5 0",
    further: true,
  },
  section: {
    title: "Line of discharge",
    key: "f",
    points: Infinity,
    hint: "Click points; Enter finishes. Flow to the right of the line is positive.",
    icon: "M8 2v12M3 6h8M9 4l2 2-2 2M3 11h8M9 9l2 2-2 2",
    further: true,
  },
  heave: {
    title: "Block of heave",
    key: "h",
    points: 2,
    hint: "Click two opposite corners; the lower one is the level of its base.",
    icon: "M4 4v9h8V4M8 11V5M6 7l2-2 2 2",
    further: true,
  },
  slurry: {
    title: "Slurry",
    key: "q",
    points: 2,
    hint: "Click from where to where; the higher point is its level. Its unit weight is in the form.",
    icon: "M2 3h3v10h6V3h3M5 5h6M6 7.500h1M9 7.500h1M7.500 10h1",
    further: true,
  },
  picture: {
    title: "Place the background picture",
    key: "k",
    points: 2,
    hint: "Click two points of the picture whose coordinates are known, then type these beside the canvas.",
    icon: "M2 3h12v10H2zM2 11l4-4 3 3 2-2 3 3M11 5.500v.01",
    further: true,
  },
};
