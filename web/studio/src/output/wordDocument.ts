// SPDX-License-Identifier: MIT
/** A summary of the case as a document for word processors (docx); loaded with its library when it is asked for. */
import { AlignmentType, BorderStyle, Document, Footer, HeadingLevel, ImageRun, Packer, PageNumber, Paragraph, Table, TableCell, TableRow, TextRun, WidthType } from "docx";

import type { Summary, Table as Rows } from "./summary";

export interface Picture {
  data: Uint8Array;
  /** [px] */
  width: number;
  height: number;
}

/** Width of the text on A4 with margins of 2.5 cm: in pixels of 1/96 inch, and in twentieths of a point. */
const [widthInPixels, widthInTwips] = [600, 9070];
const tallestPicture = 480;
const margin = 1417;

const line = { style: BorderStyle.SINGLE, size: 4, color: "B8BEC6" };
const none = { style: BorderStyle.NONE, size: 0, color: "FFFFFF" };
const borders = { top: line, bottom: line, left: none, right: none };

function makeTable({ head, rows }: Rows, widths: number[]): Table {
  const total = widths.reduce((sum, w) => sum + w, 0);
  const columns = widths.map((w) => Math.round((w / total) * widthInTwips));
  const makeRow = (cells: string[], isHead: boolean) =>
    new TableRow({
      tableHeader: isHead,
      cantSplit: true,
      children: cells.map(
        (text, i) =>
          new TableCell({
            borders,
            width: { size: columns[i]!, type: WidthType.DXA },
            margins: { top: 40, bottom: 40, left: 60, right: 60 },
            children: [new Paragraph({ children: [new TextRun({ text, bold: isHead })] })],
          }),
      ),
    });
  return new Table({
    width: { size: widthInTwips, type: WidthType.DXA },
    columnWidths: columns,
    rows: [...(head.length ? [makeRow(head, true)] : []), ...rows.map((cells) => makeRow(cells, false))],
  });
}

const heading = (text: string) => new Paragraph({ text, heading: HeadingLevel.HEADING_2, spacing: { before: 280, after: 100 }, keepNext: true });
const sentence = (text: string) => new Paragraph({ text, spacing: { after: 100 } });
const bullet = (text: string) => new Paragraph({ text, bullet: { level: 0 } });

function drawPicture({ data, width, height }: Picture, title: string): Paragraph {
  const scale = Math.min(widthInPixels / width, tallestPicture / height);
  const size = { width: Math.round(width * scale), height: Math.round(height * scale) };
  const altText = { name: "section", title: "Section", description: `Section of ${title}` };
  return new Paragraph({ alignment: AlignmentType.CENTER, children: [new ImageRun({ type: "png", data, transformation: size, altText })] });
}

export function writeDocument(summary: Summary, picture: Picture | null): Promise<Blob> {
  const { title, facts, factors, note, soils, lists, warnings, noWarnings } = summary;
  const content = [
    new Paragraph({ text: title, heading: HeadingLevel.HEADING_1, spacing: { after: 160 } }),
    makeTable({ head: [], rows: facts }, [2, 7]),
    ...(picture ? [heading("Section"), drawPicture(picture, title)] : []),
    heading("Factors of safety"),
    ...(note ? [sentence(note)] : []),
    ...(factors.rows.length ? [makeTable(factors, factors.head.length > 3 ? [3, 5, 2, 3, 4] : [3, 5, 2])] : []),
    heading("Soils"),
    ...soils.flatMap(({ name, table }) => [
      new Paragraph({ text: name, heading: HeadingLevel.HEADING_3, spacing: { before: 160, after: 60 }, keepNext: true }),
      makeTable(table, [4, 4, 2]),
    ]),
    ...lists.flatMap((list) => [heading(list.title), ...list.lines.map(bullet)]),
    heading("Warnings"),
    ...(warnings.length ? warnings.map(bullet) : [sentence(noWarnings)]),
  ];
  const footer = new Footer({
    children: [
      new Paragraph({
        alignment: AlignmentType.RIGHT,
        children: [new TextRun({ size: 16, children: [`${title} · page `, PageNumber.CURRENT, " of ", PageNumber.TOTAL_PAGES] })],
      }),
    ],
  });
  const font = "Arial";
  const headingLook = (size: number) => ({ run: { font, size, bold: true, color: "1B2330" } });
  return Packer.toBlob(
    new Document({
      title,
      creator: "Talus",
      styles: { default: { document: { run: { font, size: 20 } }, heading1: headingLook(34), heading2: headingLook(25), heading3: headingLook(21) } },
      sections: [
        {
          properties: { page: { size: { width: 11906, height: 16838 }, margin: { top: margin, bottom: margin, left: margin, right: margin } } },
          footers: { default: footer },
          children: content,
        },
      ],
    }),
  );
}
