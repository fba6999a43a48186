/** What all parts of the contract share: units, packed arrays, columns. */

/** How a quantity is shown: value in SI = value shown × si. */
export interface Unit {
  name: string;
  si: number;
}

/**
 * An array kept outside the JSON document, in a `<script type="text/plain" id="...">`: base64 of a zlib stream of the
 * numbers, little endian. With `planes` the bytes stand as planes (all lowest bytes first, then all next ones); with
 * `delta` each row along the first axis holds the differences (modulo the type's range) to the row before it.
 * (never of an `f32`). `u16` with `range`: value = min + q / 65534 × (max - min); q = 65535 stands for "no value".
 */
export interface PackedArray {
  id: string;
  type: "u8" | "u16" | "u32" | "f32";
  shape: number[];
  delta: boolean;
  planes: boolean;
  range?: [number, number];
}

export interface Column {
  name: string;
  title: string;
  /** Unit as written; values are already in it. */
  unit: string;
  /** null where there is no value. */
  values: (number | null)[];
}
