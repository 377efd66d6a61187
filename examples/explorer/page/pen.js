// A pen: paths and labels in CSS pixels, on a canvas or into an SVG document. What is drawn by one can be
// saved by the other, so a picture is described once.
//
// style: {stroke, width, fill, dash, alpha, cap, join}; a path is the text of an SVG path. label style:
// {size, color, align: "start" | "middle" | "end", weight, halo, math}; in a label "_{...}" is a subscript,
// and a letter of a formula stands in italics.

const text_fonts = "system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', 'Noto Sans', Arial, sans-serif";
const math_fonts = "'STIX Two Text', 'Cambria', 'P052', 'Palatino Linotype', Palatino, 'Times New Roman', serif";

// The matrix that puts an image's upper left corner, upper right and lower left one at these pixels.
const image_matrix = (source, a, b, c) => [
  (b[0] - a[0]) / source.width,
  (b[1] - a[1]) / source.width,
  (c[0] - a[0]) / source.height,
  (c[1] - a[1]) / source.height,
  a[0],
  a[1],
];

// The parts of a label: [{text, sub}].
function label_parts(label) {
  return label
    .split(/(_\{[^}]*\})/)
    .filter(part => part)
    .map(part => (part.startsWith('_{') ? {text: part.slice(2, -1), sub: true} : {text: part, sub: false}));
}

const font_of = (style, sub) =>
  `${style.math && !sub ? 'italic ' : ''}${style.weight || 400} ${(style.size || 13) * (sub ? 0.75 : 1)}px ` +
  (style.math ? math_fonts : text_fonts);

// The width of a label [pixels], measured where there is a document.
let ruler = null;
function label_width(label, style) {
  if (typeof document === 'undefined') return 0.55 * (style.size || 13) * label.length;
  ruler ??= document.createElement('canvas').getContext('2d');
  return label_parts(label).reduce((sum, part) => {
    ruler.font = font_of(style, part.sub);
    return sum + ruler.measureText(part.text).width;
  }, 0);
}

export function canvas_pen(canvas) {
  const context = canvas.getContext('2d');
  return {
    width: 0,
    height: 0,
    // Clears the canvas, with so many pixels for one, after its size has followed that of its box.
    begin(width = canvas.clientWidth, height = canvas.clientHeight, ratio = Math.min(3, devicePixelRatio || 1)) {
      const columns = Math.round(width * ratio),
        rows = Math.round(height * ratio);
      if (canvas.width !== columns || canvas.height !== rows) Object.assign(canvas, {width: columns, height: rows});
      Object.assign(this, {width, height});
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      context.clearRect(0, 0, width, height);
    },
    path(d, style) {
      const path = new Path2D(d);
      context.globalAlpha = style.alpha ?? 1;
      if (style.fill) {
        context.fillStyle = style.fill;
        context.fill(path);
      }
      if (style.stroke) {
        context.strokeStyle = style.stroke;
        context.lineWidth = style.width ?? 1;
        context.lineCap = style.cap || 'round';
        context.lineJoin = style.join || 'round';
        context.setLineDash(style.dash || []);
        context.stroke(path);
      }
      context.globalAlpha = 1;
    },
    clip(d, draw) {
      context.save();
      context.clip(new Path2D(d));
      draw();
      context.restore();
    },
    label(text, x, y, style = {}) {
      let at = x - label_width(text, style) * (style.align === 'middle' ? 0.5 : style.align === 'end' ? 1 : 0);
      context.textBaseline = 'alphabetic';
      context.textAlign = 'left';
      context.lineJoin = 'round';
      context.setLineDash([]);
      for (const part of label_parts(text)) {
        context.font = font_of(style, part.sub);
        const base = y + (part.sub ? (style.size || 13) * 0.22 : 0);
        if (style.halo) {
          context.strokeStyle = style.halo;
          context.lineWidth = 4;
          context.strokeText(part.text, at, base);
        }
        context.fillStyle = style.color;
        context.fillText(part.text, at, base);
        at += context.measureText(part.text).width;
      }
    },
    // An image whose upper left corner, upper right and lower left one are at these pixels.
    image(source, a, b, c, alpha) {
      context.save();
      context.globalAlpha = alpha;
      context.imageSmoothingEnabled = false;
      context.transform(...image_matrix(source, a, b, c));
      context.drawImage(source, 0, 0);
      context.restore();
    },
  };
}

export function svg_pen(width, height, background) {
  const body = [],
    definitions = [];
  const escape = text => text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/"/g, '&quot;');
  const round = number => Math.round(number * 100) / 100;
  return {
    width,
    height,
    path(d, style) {
      body.push(
        `<path d="${d}" fill="${style.fill || 'none'}"` +
          (style.stroke
            ? ` stroke="${style.stroke}" stroke-width="${style.width ?? 1}" stroke-linecap="${style.cap || 'round'}" stroke-linejoin="${style.join || 'round'}"`
            : '') +
          (style.dash && style.dash.length ? ` stroke-dasharray="${style.dash.join(' ')}"` : '') +
          (style.alpha !== undefined ? ` opacity="${style.alpha}"` : '') +
          '/>',
      );
    },
    clip(d, draw) {
      const name = 'clip' + definitions.length;
      definitions.push(`<clipPath id="${name}"><path d="${d}"/></clipPath>`);
      body.push(`<g clip-path="url(#${name})">`);
      draw();
      body.push('</g>');
    },
    label(text, x, y, style = {}) {
      const size = style.size || 13;
      let shifted = false;
      const spans = label_parts(text)
        .map(part => {
          const shift = part.sub !== shifted ? ` dy="${round(size * (part.sub ? 0.22 : -0.22))}"` : '';
          shifted = part.sub;
          return `<tspan${shift}${part.sub ? ` font-size="${round(size * 0.75)}" font-style="normal"` : ''}>${escape(part.text)}</tspan>`;
        })
        .join('');
      body.push(
        `<text x="${round(x)}" y="${round(y)}" font-family="${style.math ? math_fonts : text_fonts}" font-size="${size}"` +
          (style.math ? ' font-style="italic"' : '') +
          (style.weight ? ` font-weight="${style.weight}"` : '') +
          ` text-anchor="${style.align || 'start'}" fill="${style.color}"` +
          (style.halo ? ` stroke="${style.halo}" stroke-width="4" stroke-linejoin="round" paint-order="stroke"` : '') +
          `>${spans}</text>`,
      );
    },
    image(source, a, b, c, alpha) {
      const matrix = image_matrix(source, a, b, c);
      body.push(
        `<image width="${source.width}" height="${source.height}" transform="matrix(${matrix.join(' ')})" opacity="${alpha}" style="image-rendering:pixelated" href="${source.toDataURL()}"/>`,
      );
    },
    text() {
      return (
        `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">` +
        `<defs>${definitions.join('')}</defs><rect width="100%" height="100%" fill="${background}"/>${body.join('\n')}</svg>\n`
      );
    },
  };
}

// Texts of paths.
const pixels = number => number.toFixed(2);
// Labels that neither leave the picture nor lie on each other. put() draws a label at the first free place around
// a pixel, from a direction on, at a distance, and returns its middle; take() keeps a box free.
export function make_labels(pen) {
  const taken = [];
  const is_free = ([x, y, w, h]) =>
    x - w > 3 &&
    x + w < pen.width - 3 &&
    y - h > 3 &&
    y + h < pen.height - 3 &&
    taken.every(([u, v, a, b]) => Math.abs(x - u) >= w + a || Math.abs(y - v) >= h + b);
  return {
    take: (x, y, w, h) => taken.push([x, y, w, h]),
    put(text, at, direction, distance, style) {
      const w = label_width(text, style) / 2 + 2,
        h = 0.62 * (style.size || 13),
        start = Math.atan2(direction[1], direction[0]);
      let best = null;
      for (let k = 0; k < 48 && !best; ++k) {
        const turn = start + ((k % 2 ? 1 : -1) * Math.ceil((k % 16) / 2) * Math.PI) / 8,
          far = distance + 13 * Math.floor(k / 16),
          [c, s] = [Math.cos(turn), Math.sin(turn)],
          box = [at[0] + c * (far + w), at[1] + s * (far + h), w, h];
        if (is_free(box)) best = box;
      }
      best ??= [
        Math.min(pen.width - w - 4, Math.max(w + 4, at[0] + direction[0] * (distance + w))),
        Math.min(pen.height - h - 4, Math.max(h + 4, at[1] + direction[1] * (distance + h))),
        w,
        h,
      ];
      taken.push(best);
      pen.label(text, best[0], best[1] + 0.36 * (style.size || 13), {...style, align: 'middle'});
      return best;
    },
  };
}

export const line_path = (a, b) => `M${pixels(a[0])} ${pixels(a[1])}L${pixels(b[0])} ${pixels(b[1])}`;
export function points_path(points, is_closed = false) {
  let d = '';
  for (let k = 0; k < points.length; ++k) d += (k ? 'L' : 'M') + pixels(points[k][0]) + ' ' + pixels(points[k][1]);
  return is_closed && d ? d + 'Z' : d;
}
export function circle_path([x, y], r) {
  return `M${pixels(x - r)} ${pixels(y)}A${pixels(r)} ${pixels(r)} 0 1 1 ${pixels(x + r)} ${pixels(y)}A${pixels(r)} ${pixels(r)} 0 1 1 ${pixels(x - r)} ${pixels(y)}Z`;
}
