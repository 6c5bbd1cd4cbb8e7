// One set of drawing verbs for the screen (canvas) and for papers (SVG).
//
// A track is a flat array x0, y0, x1, y1, ... [px, y downwards]; a style has stroke, width, dash, fill and closed.

const FONT = "\"Helvetica Neue\", Arial, \"DejaVu Sans\", sans-serif";

class CanvasSurface {
  constructor(canvas, width, height) {
    const density = window.devicePixelRatio || 1;
    canvas.width = Math.round(width * density);
    canvas.height = Math.round(height * density);
    canvas.style.height = `${height}px`;
    this.context = canvas.getContext("2d");
    this.density = density;
    this.context.scale(density, density);
    this.context.fillStyle = PAPER;
    this.context.fillRect(0, 0, width, height);
  }

  tracks(tracks, style) {
    const context = this.context;
    // A path of very many pieces is slow to fill; several of some pieces are not.
    const pieces = 500;
    context.lineWidth = style.width ?? 1;
    context.setLineDash(style.dash ?? []);
    context.lineJoin = context.lineCap = "round";
    for (let first = 0; first < tracks.length; first += pieces) {
      context.beginPath();
      for (let t = first; t < Math.min(tracks.length, first + pieces); t += 1) this.trace(tracks[t], style.closed);
      if (style.fill) {
        context.fillStyle = style.fill;
        context.fill();
      }
      if (style.stroke) {
        context.strokeStyle = style.stroke;
        context.stroke();
      }
    }
  }

  trace(track, closed) {
    this.context.moveTo(track[0], track[1]);
    for (let i = 2; i < track.length; i += 2) this.context.lineTo(track[i], track[i + 1]);
    if (closed) this.context.closePath();
  }

  /** Many small polygons without edges, by bins of colour, onto the empty upper part of the picture. */
  smallPolygons(bins, width, height) {
    const raster = new Raster(Math.round(width * this.density), Math.round(height * this.density));
    for (const [colour, outlines] of bins) {
      const number = Raster.colour(colour);
      for (const outline of outlines)
        raster.fill(this.density === 1 ? outline : outline.map((place) => place * this.density), number);
    }
    this.context.putImageData(raster.image(), 0, 0);
  }

  circle(x, y, radius, style) {
    this.context.beginPath();
    this.context.setLineDash([]);
    this.context.arc(x, y, radius, 0, 2 * Math.PI);
    if (style.fill) {
      this.context.fillStyle = style.fill;
      this.context.fill();
    }
    if (!style.stroke) return;
    this.context.lineWidth = style.width ?? 1;
    this.context.strokeStyle = style.stroke;
    this.context.stroke();
  }

  text(x, y, text, {size = 11, anchor = "start", bold = false, rotate = 0, fill = INK} = {}) {
    const context = this.context;
    context.save();
    context.translate(x, y);
    context.rotate((rotate * Math.PI) / 180);
    context.font = `${bold ? "600 " : ""}${size}px ${FONT}`;
    context.textAlign = anchor === "middle" ? "center" : anchor;
    context.fillStyle = fill;
    context.fillText(text, 0, 0);
    context.restore();
  }

  clipped({x, y, width, height}, draw) {
    this.context.save();
    this.context.beginPath();
    this.context.rect(x, y, width, height);
    this.context.clip();
    draw();
    this.context.restore();
  }
}

class SvgSurface {
  constructor(width, height) {
    this.width = width;
    this.height = height;
    this.parts = [];
    this.numClips = 0;
  }

  tracks(tracks, {stroke = "none", width = 1, dash, fill = "none", closed = false}) {
    const data = tracks.map((track) => pathData(track, closed)).join("");
    if (data === "") return;
    const dashes = dash?.length ? ` stroke-dasharray="${dash.join(" ")}"` : "";
    const line =
        stroke === "none" ? "" : ` stroke-width="${width}"${dashes} stroke-linejoin="round" stroke-linecap="round"`;
    this.parts.push(`<path d="${data}" fill="${onPaper(fill)}" stroke="${onPaper(stroke)}"${line}/>`);
  }

  circle(x, y, radius, {stroke = "none", width = 1, fill = "none"}) {
    this.parts.push(
        `<circle cx="${fixed(x)}" cy="${fixed(y)}" r="${radius}" fill="${onPaper(fill)}" stroke="${onPaper(stroke)}" ` +
        `stroke-width="${width}"/>`);
  }

  text(x, y, text, {size = 11, anchor = "start", bold = false, rotate = 0, fill = INK} = {}) {
    const turn = rotate ? ` transform="rotate(${rotate} ${fixed(x)} ${fixed(y)})"` : "";
    this.parts.push(
        `<text x="${fixed(x)}" y="${fixed(y)}" font-size="${size}" text-anchor="${anchor}" ` +
        `fill="${onPaper(fill)}"${bold ? " font-weight=\"600\"" : ""}${turn}>${escapedText(text)}</text>`);
  }

  clipped({x, y, width, height}, draw) {
    this.numClips += 1;
    const id = `clip${this.numClips}`;
    this.parts.push(
        `<clipPath id="${id}"><rect x="${fixed(x)}" y="${fixed(y)}" width="${fixed(width)}" ` +
        `height="${fixed(height)}"/></clipPath><g clip-path="url(#${id})">`);
    draw();
    this.parts.push("</g>");
  }

  document() {
    return `<svg xmlns="http://www.w3.org/2000/svg" width="${fixed(this.width)}" height="${fixed(this.height)}" ` +
        `viewBox="0 0 ${fixed(this.width)} ${fixed(this.height)}" font-family='${FONT}'>\n` +
        `<rect width="100%" height="100%" fill="#fff"/>\n${this.parts.join("\n")}\n</svg>\n`;
  }
}

function fixed(value) {
  return String(Math.round(value * 100) / 100);
}

function pathData(track, closed) {
  let data = `M${fixed(track[0])} ${fixed(track[1])}`;
  for (let i = 2; i < track.length; i += 2) data += `L${fixed(track[i])} ${fixed(track[i + 1])}`;
  return closed ? `${data}Z` : data;
}

function escapedText(text) {
  return String(text).replace(/[&<>]/g, (character) => ({"&": "&amp;", "<": "&lt;", ">": "&gt;"})[character]);
}
