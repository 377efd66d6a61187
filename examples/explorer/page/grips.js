// Grips: points of the picture that a mouse, a finger or the arrow keys move. Each is a button over the
// canvas, so that Tab finds it and a screen reader names it.

const key_moves = {
  ArrowLeft: [-1, 0, 0],
  ArrowRight: [1, 0, 0],
  ArrowUp: [0, 1, 0],
  ArrowDown: [0, -1, 0],
  PageUp: [0, 0, 1],
  PageDown: [0, 0, -1],
};

// container: the element that covers the picture. add({id, className, moved(pixel, start), keyed([x, y,
// z]), grabbed(), released()}) makes a grip; place(id, pixel) puts it, or hides it if pixel is null;
// name(id, text) names it.
export function make_grips(container) {
  const grips = new Map();
  const pixel_of = event => {
    const box = container.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  return {
    add(grip) {
      const element = document.createElement('button');
      element.type = 'button';
      element.className = 'grip ' + (grip.className || '');
      element.id = 'grip_' + grip.id;
      let offset = null;
      element.addEventListener('pointerdown', event => {
        if (event.button) return;
        const pixel = pixel_of(event),
          at = grips.get(grip.id).pixel;
        offset = grip.className === 'scene' || !at ? [0, 0] : [at[0] - pixel[0], at[1] - pixel[1]];
        element.setPointerCapture(event.pointerId);
        grip.grabbed?.(pixel);
        event.preventDefault();
        element.focus({preventScroll: true, focusVisible: false});
      });
      element.addEventListener('pointermove', event => {
        if (!offset) return;
        const pixel = pixel_of(event);
        grip.moved([pixel[0] + offset[0], pixel[1] + offset[1]]);
      });
      for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'])
        element.addEventListener(end, () => {
          if (offset) {
            offset = null;
            grip.released?.();
          }
        });
      element.addEventListener('keydown', event => {
        const move = key_moves[event.key];
        if (!move || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        grip.keyed(move.map(c => c * (event.shiftKey ? 5 : 1)));
      });
      container.append(element);
      grips.set(grip.id, {element, pixel: null, text: ''});
    },
    place(id, pixel) {
      const grip = grips.get(id);
      if (!grip) return;
      grip.pixel = pixel;
      grip.element.hidden = !pixel;
      if (pixel) grip.element.style.transform = `translate(${pixel[0].toFixed(1)}px,${pixel[1].toFixed(1)}px)`;
    },
    // Marks the grip that a step is about.
    mark: (id, is_marked) => grips.get(id).element.classList.toggle('marked', is_marked),
    name(id, text) {
      const grip = grips.get(id);
      if (grip.text !== text) {
        grip.text = text;
        grip.element.setAttribute('aria-label', text);
      }
    },
  };
}
