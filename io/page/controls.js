// The switches beside the view.
'use strict';
if (viewer) (function () {
  const controls = document.getElementById('controls'), view = document.getElementById('view');
  const {scene} = model, {layers, edgeSets, boundary, cut} = viewer, {colourings, rampColour} = drawing;
  function element(tag, parent, attributes, text) {
    const made = document.createElement(tag);
    for (const name in attributes) made.setAttribute(name, attributes[name]);
    if (text !== undefined) made.appendChild(document.createTextNode(text));
    parent.appendChild(made);
    return made;
  }
  function group(title) {
    const set = element('fieldset', controls, {});
    element('legend', set, {}, title);
    return set;
  }
  function choice(parent, type, attributes, text, change) {
    const label = element('label', parent, {});
    const input = element('input', label, Object.assign({type}, attributes));
    label.appendChild(document.createTextNode(' ' + text));
    input.addEventListener('change', () => change(input));
    return input;
  }

  const show = group('Show');
  for (const item of layers.concat(edgeSets)) {
    choice(show, 'checkbox', Object.assign({id: 'show-' + item.id}, item.wanted ? {checked: ''} : {}), item.name,
      input => { item.wanted = input.checked; viewer.showLayers(); });
    if (item.edges)
      choice(show, 'checkbox', {id: 'show-edges', checked: ''}, 'edges of the boundary',
        input => { item.edges.visible = input.checked; viewer.draw(); });
  }
  if (overlay.hasMarks)
    choice(show, 'checkbox', {id: 'show-marks', checked: ''}, 'places', input => viewer.showMarks(input.checked));
  if (boundary) {
    element('label', show, {for: 'opacity'}, 'opacity of the boundary');
    const opacity = element('input', show,
      {type: 'range', id: 'opacity', min: 0, max: 1, step: 0.05, value: boundary.opacity});
    opacity.addEventListener('input', () => viewer.setOpacity(Number(opacity.value)));
    view.addEventListener('opacity', () => { opacity.value = boundary.opacity; });
  }

  const offered = Object.keys(colourings).filter(name => colourings[name].usable !== false);
  if (boundary && offered.length > 1) {
    const colours = group('Colour by');
    for (const name of offered)
      choice(colours, 'radio',
        Object.assign({name: 'colouring', id: 'colour-' + name}, name === 'plain' ? {checked: ''} : {}),
        colourings[name].name, () => { showKey(name); viewer.colourBy(name); });
    const key = element('div', colours, {id: 'key'}), ends = element('div', colours, {id: 'key-ends'});
    const words = element('ul', colours, {id: 'key-words'});
    for (let i = 0; i < 24; ++i) element('span', key, {}).style.background = '#' + rampColour(i / 23).getHexString();
    const showKey = name => {
      const range = colourings[name].ends;
      key.style.display = ends.style.display = range ? '' : 'none';
      ends.textContent = words.textContent = '';
      for (const end of range || []) element('span', ends, {}, end);
      for (const [word, colour] of colourings[name].words || [])
        element('li', words, {}, word).style.borderColor = colour;
    };
    showKey('plain');
  }

  if (scene.cut_tets > 0) {
    const cuts = group('Cut: whole tetrahedra behind a plane');
    const apply = () => { viewer.applyCut(); where.textContent = viewer.planeText(); };
    for (const axis of ['', ...scene.cut_axes])
      choice(cuts, 'radio', Object.assign({name: 'cut', id: 'cut-' + (axis || 'none')}, axis ? {} : {checked: ''}),
        axis || 'none', () => { cut.axis = axis; apply(); });
    if (scene.cut_anywhere) {
      const at = element('input', cuts, {type: 'range', id: 'cut-at', min: -0.5, max: 0.5, step: 0.005, value: 0,
        'aria-label': 'place of the plane'});
      at.addEventListener('input', () => { cut.at = Number(at.value); if (cut.axis) apply(); });
    }
    const where = element('div', cuts, {id: 'cut-place'});
    choice(cuts, 'checkbox', {id: 'cut-flip'}, 'from the other side',
      input => { cut.flipped = input.checked; if (cut.axis) apply(); });
  }
  element('button', controls, {type: 'button', id: 'home'}, 'show all').addEventListener('click', viewer.showAll);
  if (model.low[0] <= model.high[0] && scene.points) {
    const number = value => String(Number(value.toPrecision(6)));
    element('p', controls, {id: 'box'}, 'What is drawn lies in ' + ['x', 'y', 'z'].map((name, k) =>
      name + ' ' + number(model.low[k]) + ' to ' + number(model.high[k])).join(', ') + '.');
  }
  viewer.start();
})();
