// Words over the view: marked places, and in the corner the directions of the axes.
'use strict';
const overlay = (function () {
  const stage = document.getElementById('stage'), {scene, toUnits} = model;
  function word(kind, text, colour) {
    const made = document.createElement('span');
    made.className = kind;
    made.textContent = text;
    made.style.color = colour;
    stage.appendChild(made);
    return made;
  }
  const marks = scene.marks.map(given => ({
    at: new THREE.Vector3(...given.point.map(toUnits)), dot: word('dot', '', given.colour),
    word: word('mark', given.text, given.colour), width: 0,
  }));
  const axes = [['x', '#b3122a'], ['y', '#1b7a3d'], ['z', '#1f5a99']].map(([name, colour], k) => {
    const line = document.createElementNS('http://www.w3.org/2000/svg', 'line');
    line.setAttribute('stroke', colour);
    document.getElementById('axes').appendChild(line);
    return {line, word: word('axis-name', name, colour), along: new THREE.Vector3().setComponent(k, 1)};
  });
  function placeMarks(camera, shown) {
    const width = stage.clientWidth, height = stage.clientHeight, placed = [];
    for (const mark of marks) {
      const p = mark.at.clone().project(camera);
      const inside = shown && Math.abs(p.x) <= 1 && Math.abs(p.y) <= 1 && p.z < 1;
      mark.word.style.display = mark.dot.style.display = inside ? '' : 'none';
      if (!inside) continue;
      mark.width = mark.width || mark.word.offsetWidth;
      const left = (p.x + 1) / 2 * width, top = (1 - p.y) / 2 * height;
      mark.dot.style.left = left - 4 + 'px';
      mark.dot.style.top = top - 4 + 'px';
      // Words that would hide each other stand one below the other.
      const label = {left: left + 6, right: left + 6 + mark.width, top: top - 9};
      const hides = other => label.left < other.right && other.left < label.right
        && Math.abs(label.top - other.top) < 16;
      for (let tries = 0; tries < 8 && placed.some(hides); ++tries) label.top += 8;
      placed.push(label);
      mark.word.style.left = label.left + 'px';
      mark.word.style.top = label.top + 'px';
    }
  }
  function placeAxes(camera) {
    const turned = camera.quaternion.clone().conjugate();
    for (const axis of axes) {
      const p = axis.along.clone().applyQuaternion(turned);
      axis.line.setAttribute('x2', (26 * p.x).toFixed(2));
      axis.line.setAttribute('y2', (-26 * p.y).toFixed(2));
      axis.word.style.left = 42 + 34 * p.x - 4 + 'px';
      axis.word.style.bottom = 42 + 34 * p.y - 8 + 'px';
    }
  }
  return {
    marksShown: true,
    hasMarks: marks.length > 0,
    place(camera) { placeMarks(camera, this.marksShown); placeAxes(camera); },
  };
})();
