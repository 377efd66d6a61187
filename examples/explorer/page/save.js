// Files that the visitor takes along: the picture as SVG or PNG, the record as a log.

export function save_text(name, text, type) {
  save_blob(name, new Blob([text], {type}));
}

function save_blob(name, blob) {
  const link = document.createElement('a'),
    address = URL.createObjectURL(blob);
  link.href = address;
  link.download = name;
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}

// The picture of an SVG text as PNG, with so many pixels for one.
export async function save_png(name, svg, width, height, ratio) {
  const address = URL.createObjectURL(new Blob([svg], {type: 'image/svg+xml'}));
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    const canvas = document.createElement('canvas');
    canvas.width = width * ratio;
    canvas.height = height * ratio;
    canvas.getContext('2d').drawImage(image, 0, 0, canvas.width, canvas.height);
    save_blob(name, await new Promise(done => canvas.toBlob(done, 'image/png')));
  } finally {
    URL.revokeObjectURL(address);
  }
}

// Calls take(text, name) with each file that is dropped on the page or chosen in an input.
export function watch_files(page, input, take) {
  const read = async file => {
    if (file) take(await file.text(), file.name);
  };
  input.addEventListener('change', () => {
    read(input.files[0]);
    input.value = '';
  });
  page.addEventListener('dragover', event => {
    event.preventDefault();
    page.classList.add('dropping');
  });
  page.addEventListener('dragleave', event => {
    if (!event.relatedTarget) page.classList.remove('dropping');
  });
  page.addEventListener('drop', event => {
    event.preventDefault();
    page.classList.remove('dropping');
    read(event.dataTransfer.files[0]);
  });
}
