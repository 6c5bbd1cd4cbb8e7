// Filling very many small polygons: a browser takes some microseconds for each path, a pixel takes nanoseconds.

/** An image whose pixels are set by polygons, all of whose places are in its own pixels. */
class Raster {
  constructor(width, height) {
    this.width = width;
    this.height = height;
    this.pixels = new Uint32Array(width * height).fill(Raster.colour(PAPER));
    this.crossings = [];
  }

  /** A colour "#rrggbb" as the image wants it: bytes red, green, blue, opaque. */
  static colour(text) {
    const [red, green, blue] = text.match(/[0-9a-f]{2}/g).map((byte) => parseInt(byte, 16));
    return new Uint32Array(new Uint8Array([red, green, blue, 255]).buffer)[0];
  }

  /** Every pixel whose middle lies inside: polygons that share an edge leave no gap between them. */
  fill(outline, colour) {
    const [low, high] = this.rows(outline);
    for (let y = low; y <= high; y += 1) {
      const crossings = this.crossingsAt(outline, y + 0.5);
      for (let i = 0; i + 1 < crossings.length; i += 2) {
        const first = Math.max(0, Math.ceil(crossings[i] - 0.5));
        const end = Math.min(this.width, Math.ceil(crossings[i + 1] - 0.5));
        if (end > first) this.pixels.fill(colour, y * this.width + first, y * this.width + end);
      }
    }
  }

  rows(outline) {
    let [low, high] = [Infinity, -Infinity];
    for (let i = 1; i < outline.length; i += 2) {
      low = Math.min(low, outline[i]);
      high = Math.max(high, outline[i]);
    }
    return [Math.max(0, Math.ceil(low - 0.5)), Math.min(this.height - 1, Math.floor(high - 0.5))];
  }

  /** Where the outline's sides cross a row, from left to right. */
  crossingsAt(outline, y) {
    const {crossings} = this;
    crossings.length = 0;
    let last = outline.length - 2;
    for (let i = 0; i < outline.length; last = i, i += 2) {
      const [y0, y1] = [outline[last + 1], outline[i + 1]];
      if (y0 <= y !== y1 <= y) crossings.push(outline[last] + ((y - y0) * (outline[i] - outline[last])) / (y1 - y0));
    }
    return crossings.length > 2 ? crossings.sort((one, other) => one - other) : this.inOrder(crossings);
  }

  inOrder(pair) {
    if (pair[0] > pair[1]) pair.reverse();
    return pair;
  }

  image() {
    return new ImageData(new Uint8ClampedArray(this.pixels.buffer), this.width, this.height);
  }
}
