// Texts next to the picture: a note, a refusal in the words of the library.

export const by_id = id => document.getElementById(id);

export function say(text) {
  by_id('note').hidden = !text;
  by_id('note').textContent = text;
}

export function refuse(reason) {
  by_id('refused').hidden = !reason;
  by_id('refused').textContent = reason;
}

// Why a link is not opened, or nothing moves.
export function warn(reason) {
  by_id('warning').hidden = !reason;
  by_id('warning').textContent = reason;
}
