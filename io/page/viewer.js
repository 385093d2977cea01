// The page's view: draws the scene (io/page/scene.hpp), turns it, cuts it, and answers clicks. Without WebGL the
// picture and the tables stay as they are. Nothing of the scene's texts becomes markup: they are set as text.
'use strict';
(function () {
  const byId = id => document.getElementById(id);
  const view = byId('view'), stage = byId('stage'), controls = byId('controls'), told = byId('told');

  // --- the scene's arrays
  const scene = JSON.parse(byId('scene').textContent);
  function decode(text, Type) {
    const characters = atob(text), bytes = new Uint8Array(characters.length);
    for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
    return new Type(bytes.buffer);
  }
  const points = decode(scene.points, Float64Array);
  const short = decode(scene.tets, Uint8Array), tets = new Int32Array(short.length / 3);   // three bytes each
  for (let i = 0; i < tets.length; ++i) tets[i] = short[3 * i] | short[3 * i + 1] << 8 | short[3 * i + 2] << 16;
  const tetRegions = decode(scene.tet_regions, Int32Array);
  const tetCount = tets.length / 4;
  // A position's number in the file. The numbers are stored as runs that count up, or as an array.
  function numbersOf(given) {
    if (given.int32) return decode(given.int32, Int32Array);
    if (given.float64) return decode(given.float64, Float64Array);
    return given;
  }
  function numberOf(numbers, position) {
    if (!Array.isArray(numbers)) return numbers[position];
    let low = 0, high = numbers.length;
    while (high - low > 1) {
      const middle = low + high >> 1;
      if (numbers[middle][0] <= position) low = middle; else high = middle;
    }
    return numbers.length ? numbers[low][1] + position - numbers[low][0] : position;
  }
  const tetNumbers = numbersOf(scene.tet_numbers), pointNumbers = numbersOf(scene.point_numbers);
  const tetNumber = t => numberOf(tetNumbers, t);
  const pointNumber = v => numberOf(pointNumbers, v);

  // --- units: the middle of all points is the origin, and the box has a size of about 1
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; ++i) {
    if (points[i] < low[i % 3]) low[i % 3] = points[i];
    if (points[i] > high[i % 3]) high[i % 3] = points[i];
  }
  if (!points.length) { low.fill(-1); high.fill(1); }
  const middle = low.map((l, k) => l / 2 + high[k] / 2);
  const half = Math.max(...high.map((h, k) => h / 2 - low[k] / 2)) || 1;
  const toUnits = (value, k) => (value / 2 - middle[k] / 2) / half;   // halves first: no overflow at the largest doubles
  const place = new Float32Array(points.length);
  for (let i = 0; i < points.length; ++i) place[i] = toUnits(points[i], i % 3);
  const corner = v => new THREE.Vector3(place[3 * v], place[3 * v + 1], place[3 * v + 2]);
  const inUnits = p => new THREE.Vector3(toUnits(p[0], 0), toUnits(p[1], 1), toUnits(p[2], 2));

  // --- measures of a tetrahedron, in doubles and in units; the verdict's own decisions are exact
  function corners(t) {
    return [0, 1, 2, 3].map(k => [0, 1, 2].map(c => toUnits(points[3 * tets[4 * t + k] + c], c)));
  }
  const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const faces = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];
  function volume(p) { return dot(cross(minus(p[1], p[0]), minus(p[2], p[0])), minus(p[3], p[0])) / 6; }
  function dihedralAngles(p) {   // degrees, of the six edges
    const normals = faces.map(f => cross(minus(p[f[1]], p[f[0]]), minus(p[f[2]], p[f[0]])));
    const angles = [];
    for (let i = 0; i < 4; ++i) for (let j = i + 1; j < 4; ++j) {
      const n = cross(normals[i], normals[j]);
      angles.push(180 - Math.atan2(Math.sqrt(dot(n, n)), dot(normals[i], normals[j])) * 180 / Math.PI);
    }
    return angles;
  }
  let smallestAngles = null;   // of all tetrahedra, when first asked for
  function smallestAngle(t) {
    if (!smallestAngles) smallestAngles = new Float32Array(tetCount).fill(-1);
    if (smallestAngles[t] < 0) {
      const p = corners(t);
      smallestAngles[t] = volume(p) > 0 ? Math.min(...dihedralAngles(p)) : 0;
    }
    return smallestAngles[t];
  }

  // --- without WebGL all else stays
  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
  } catch (error) {
    byId('no-view').textContent = 'This browser shows no WebGL: the picture stands for the view. All tables are complete.';
    for (const button of document.querySelectorAll('[data-target]')) button.disabled = true;
    view.dataset.ready = 'without';
    return;
  }
  byId('picture').style.display = 'none';
  view.hidden = false;
  renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
  renderer.setClearColor(0xffffff);
  renderer.localClippingEnabled = true;
  stage.appendChild(renderer.domElement);
  const world = new THREE.Scene();
  const camera = new THREE.PerspectiveCamera(35, 1, 1e-5, 100);
  camera.up.set(0, 0, 1);
  const allRadius = Math.hypot(...high.map((h, k) => h / 2 - low[k] / 2)) / half / 2;   // a ball around everything
  camera.position.set(2.2, -3.2, 1.6).setLength(3 * allRadius);
  world.add(camera);
  world.add(new THREE.AmbientLight(0xffffff, 0.55));
  const lamp = new THREE.DirectionalLight(0xffffff, 0.6);
  lamp.position.set(0.3, 0.5, 1);
  camera.add(lamp);
  const orbit = new THREE.OrbitControls(camera, renderer.domElement);
  orbit.addEventListener('change', draw);

  // --- colours
  const palette = ['#4477aa', '#ee6677', '#228833', '#ccbb44', '#66ccee', '#aa3377', '#bbbbbb', '#994455', '#997700', '#44aa99'];
  const ramp = ['#414487', '#2a788e', '#22a884', '#7ad151', '#fde725'].map(c => new THREE.Color(c));
  function rampColour(part) {
    const at = Math.min(Math.max(part, 0), 1) * (ramp.length - 1), k = Math.min(Math.floor(at), ramp.length - 2);
    return ramp[k].clone().lerp(ramp[k + 1], at - k);
  }
  const grey = new THREE.Color('#9aa3ab');
  const valuesOf = scene.layers.map(layer => decode(layer.values, Float32Array));
  let largestValue = 0, anyValue = false;
  for (const values of valuesOf)
    for (const value of values) if (value >= 0) { anyValue = true; if (value > largestValue) largestValue = value; }
  const colourings = {
    plain: {name: 'one colour', of: (layer) => layer.plain},
    region: {
      name: 'region', usable: scene.regions.length > 1,
      of: (layer, tet) => tet < 0 ? layer.plain : new THREE.Color(palette[tetRegions[tet] % palette.length]),
    },
    quality: {
      name: 'smallest dihedral angle', usable: tetCount > 0, ends: ['0\u00b0', '70\u00b0'],
      of: (layer, tet) => tet < 0 ? layer.plain : rampColour(smallestAngle(tet) / 70),
    },
    value: {
      name: scene.value_name, usable: anyValue, ends: ['0', largestValue.toPrecision(3)],
      of: (layer, tet, i) => {
        const value = layer.values ? layer.values[i] : NaN;
        return value >= 0 ? rampColour(largestValue > 0 ? value / largestValue : 0) : grey;
      },
    },
  };
  let colouring = 'plain';

  // --- layers of triangles
  function geometryOf(layer, triangles, tetOf) {
    const count = triangles.length / 3, position = new Float32Array(9 * count), colour = new Float32Array(9 * count);
    for (let i = 0; i < count; ++i) {
      const v = triangles.subarray(3 * i, 3 * i + 3);
      const c = colourings[layer.coloured ? colouring : 'plain'].of(layer, tetOf.length ? tetOf[i] : -1, i);
      for (let k = 0; k < 3; ++k) {
        position.set(place.subarray(3 * v[k], 3 * v[k] + 3), 9 * i + 3 * k);
        colour.set([c.r, c.g, c.b], 9 * i + 3 * k);
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(position, 3));
    geometry.setAttribute('color', new THREE.BufferAttribute(colour, 3));
    geometry.computeVertexNormals();
    return geometry;
  }
  function sidesOf(triangles) {
    const edges = new Int32Array(2 * triangles.length);
    for (let i = 0; i < triangles.length; i += 3)
      edges.set([triangles[i], triangles[i + 1], triangles[i + 1], triangles[i + 2], triangles[i + 2], triangles[i]], 2 * i);
    return edges;
  }
  function makeLayer(given, index) {
    const layer = {
      id: given.id, name: given.name, plain: new THREE.Color(given.colour), boundary: given.boundary,
      triangles: decode(given.triangles, Int32Array), tets: decode(given.tets, Int32Array), values: valuesOf[index],
      wanted: given.shown, coloured: given.boundary, opacity: given.opacity,
    };
    const ids = decode(given.faces, Uint32Array);
    if (ids.length) {
      layer.tets = new Int32Array(ids.length);
      layer.triangles = new Int32Array(3 * ids.length);
      ids.forEach((id, i) => {
        layer.tets[i] = id >>> 2;
        faces[id & 3].forEach((corner, k) => { layer.triangles[3 * i + k] = tets[4 * (id >>> 2) + corner]; });
      });
    }
    layer.material = new THREE.MeshLambertMaterial({
      vertexColors: THREE.VertexColors, side: THREE.DoubleSide, transparent: given.opacity < 1, opacity: given.opacity,
      depthWrite: given.opacity >= 1,
      // Layers may lie in the same place: a later one is drawn before an earlier one, and edges before all.
      polygonOffset: true, polygonOffsetFactor: 1 + scene.layers.length - index, polygonOffsetUnits: 1 + scene.layers.length - index,
    });
    layer.mesh = new THREE.Mesh(geometryOf(layer, layer.triangles, layer.tets), layer.material);
    layer.mesh.renderOrder = given.opacity < 1 ? 2 : 0;
    if (given.boundary && layer.tets.length <= 60000) layer.mesh.add(layer.edges = linesOf(sidesOf(layer.triangles), '#46505a'));
    world.add(layer.mesh);
    return layer;
  }
  function linesOf(edges, colour) {
    const position = new Float32Array(3 * edges.length);
    for (let i = 0; i < edges.length; ++i) position.set(place.subarray(3 * edges[i], 3 * edges[i] + 3), 3 * i);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(position, 3));
    return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({color: colour}));
  }
  const layers = scene.layers.map(makeLayer);
  const edgeSets = scene.edges.map(given => {
    const lines = linesOf(decode(given.edges, Int32Array), given.colour);
    world.add(lines);
    return {id: given.id, name: given.name, mesh: lines, wanted: given.shown};
  });
  const boundary = layers.find(layer => layer.boundary);

  // --- the cut: whole tetrahedra behind a plane
  const cut = {axis: '', at: 0, flipped: false, mesh: null, triangles: new Int32Array(0), tets: new Int32Array(0)};
  let neighbours = null;   // of each face of the tetrahedra that can be cut, when first asked for; -1: none
  function findNeighbours() {
    const count = scene.cut_tets;
    neighbours = new Int32Array(4 * count).fill(-1);
    let size = 1024;
    while (size < 8 * count) size *= 2;
    const table = new Int32Array(size).fill(-1);
    const key = f => {
      const t = f >> 2, k = faces[f & 3];
      return [tets[4 * t + k[0]], tets[4 * t + k[1]], tets[4 * t + k[2]]].sort((a, b) => a - b);
    };
    for (let f = 0; f < 4 * count; ++f) {
      const [a, b, c] = key(f);
      let at = (Math.imul(a, 73856093) ^ Math.imul(b, 19349663) ^ Math.imul(c, 83492791)) & size - 1;
      for (;; at = at + 1 & size - 1) {
        const other = table[at];
        if (other < 0) { table[at] = f; break; }
        const k = key(other);
        if (k[0] === a && k[1] === b && k[2] === c) { neighbours[f] = other >> 2; neighbours[other] = f >> 2; break; }
      }
    }
  }
  const axisOf = {x: 0, y: 1, z: 2};
  // At first the half behind the plane, as one sees it, is kept: the view begins from +x, -y and +z.
  function flipped() { return cut.flipped !== (cut.axis === 'y'); }
  function planePlace() { return scene.cut_anywhere ? cut.at : toUnits(scene.cut_middle[axisOf[cut.axis]], axisOf[cut.axis]); }
  function computeCut() {
    if (cut.mesh) { world.remove(cut.mesh); cut.mesh.geometry.dispose(); cut.mesh = null; }
    cut.triangles = cut.tets = new Int32Array(0);
    if (!cut.axis) return;
    if (!neighbours) findNeighbours();
    const k = axisOf[cut.axis], at = planePlace(), sign = flipped() ? -1 : 1, count = scene.cut_tets;
    const kept = new Uint8Array(count);
    let keptCount = 0;
    for (let t = 0; t < count; ++t) {
      const c = [0, 1, 2, 3].map(i => place[3 * tets[4 * t + i] + k] - at);
      // Of a part of the mesh those that the plane meets; of a whole mesh those whose middle is behind it.
      const behind = scene.cut_anywhere ? sign * (c[0] + c[1] + c[2] + c[3]) <= 0 : Math.min(...c) <= 0 && Math.max(...c) >= 0;
      if (behind) { kept[t] = 1; ++keptCount; }
    }
    const triangles = [], owners = [];
    for (let t = 0; t < count; ++t) {
      if (!kept[t]) continue;
      for (let f = 0; f < 4; ++f) {
        const other = neighbours[4 * t + f];
        if (other >= 0 && kept[other]) continue;
        for (const i of faces[f]) triangles.push(tets[4 * t + i]);
        owners.push(t);
      }
    }
    cut.triangles = Int32Array.from(triangles);
    cut.tets = Int32Array.from(owners);
    cut.count = keptCount;
    const layer = {plain: new THREE.Color('#e9c46a'), coloured: true};
    cut.mesh = new THREE.Mesh(geometryOf(layer, cut.triangles, cut.tets),
      new THREE.MeshLambertMaterial({vertexColors: THREE.VertexColors, side: THREE.DoubleSide, polygonOffset: true,
        polygonOffsetFactor: 1, polygonOffsetUnits: 1}));
    const sides = linesOf(sidesOf(cut.triangles), '#2b3137');
    sides.material.transparent = true;   // very many edges would make all black
    sides.material.opacity = Math.min(1, Math.max(0.12, 6000 / Math.max(1, cut.tets.length)));
    cut.mesh.add(sides);
    world.add(cut.mesh);
  }
  // Where the whole mesh can be cut, the cut takes the boundary's place; else the plane cuts the boundary and the surface.
  function applyCut() {
    computeCut();
    const planes = [];
    if (cut.axis) {
      const normal = new THREE.Vector3();
      normal.setComponent(axisOf[cut.axis], flipped() ? 1 : -1);
      planes.push(new THREE.Plane(normal, flipped() ? -planePlace() : planePlace()));
    }
    for (const layer of layers)
      if (layer.boundary || layer.id === 'surface') {
        layer.material.clippingPlanes = planes;
        if (layer.edges) layer.edges.material.clippingPlanes = planes;
      }
    showLayers();
  }
  function showLayers() {
    for (const layer of layers) layer.mesh.visible = layer.wanted && !(layer.boundary && cut.axis && scene.cut_anywhere);
    for (const edges of edgeSets) edges.mesh.visible = edges.wanted;
    draw();
  }

  // --- marks: words beside points, as elements over the picture
  const marks = scene.marks.map(given => {
    const word = document.createElement('span');
    word.className = 'mark';
    word.textContent = '\u25cf ' + given.text;
    word.style.color = given.colour;
    stage.appendChild(word);
    return {at: inUnits(given.point), word};
  });
  function placeMarks() {
    const width = stage.clientWidth, height = stage.clientHeight, shown = marksShown;
    for (const mark of marks) {
      const p = mark.at.clone().project(camera);
      const inside = shown && Math.abs(p.x) <= 1 && Math.abs(p.y) <= 1 && p.z < 1;
      mark.word.style.display = inside ? '' : 'none';
      mark.word.style.left = (p.x + 1) / 2 * width - 6 + 'px';
      mark.word.style.top = (1 - p.y) / 2 * height - 9 + 'px';
    }
  }
  let marksShown = true;

  let asked = false;
  function draw() {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      const distance = camera.position.distanceTo(orbit.target);   // depths are told apart best around the target
      camera.near = distance / 500;
      camera.far = distance + 4 * allRadius;
      camera.updateProjectionMatrix();
      renderer.render(world, camera);
      placeMarks();
      tellState();
    });
  }
  // What is seen, for those who cannot see it: tests, mostly.
  function tellState() {
    view.dataset.ready = 'yes';
    view.dataset.cutTets = cut.axis ? cut.count : 0;
    view.dataset.cutTriangles = cut.tets.length;
    view.dataset.target = orbit.target.toArray().map(c => c.toFixed(6)).join(' ');
    view.dataset.distance = camera.position.distanceTo(orbit.target).toPrecision(6);
    view.dataset.shown = layers.filter(l => l.mesh.visible).map(l => l.id).concat(edgeSets.filter(e => e.mesh.visible).map(e => e.id)).join(' ');
    view.dataset.colouring = colouring;
  }
  function resize() {
    const width = stage.clientWidth, height = stage.clientHeight;
    renderer.setSize(width, height);
    camera.aspect = width / Math.max(height, 1);
    camera.updateProjectionMatrix();
    draw();
  }
  window.addEventListener('resize', resize);

  // --- what was chosen: an outline and words
  let outline = null;
  function select(tetList, nodes, text, kind) {
    if (outline) { world.remove(outline); outline = null; }
    outline = new THREE.Group();
    const edges = [];
    for (const t of tetList)
      for (const [i, j] of [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]]) edges.push(tets[4 * t + i], tets[4 * t + j]);
    const lines = linesOf(edges, '#d0021b');
    lines.material.depthTest = false;
    lines.renderOrder = 9;
    outline.add(lines);
    const dots = new THREE.Points(new THREE.BufferGeometry(), new THREE.PointsMaterial({color: '#d0021b', size: 8, sizeAttenuation: false, depthTest: false}));
    const at = new Float32Array(3 * nodes.length);
    nodes.forEach((v, i) => at.set(place.subarray(3 * v, 3 * v + 3), 3 * i));
    dots.geometry.setAttribute('position', new THREE.BufferAttribute(at, 3));
    dots.renderOrder = 9;
    outline.add(dots);
    world.add(outline);
    told.textContent = text;
    view.dataset.selected = kind;
    draw();
  }
  // Lengths, areas and volumes may be too large or small for doubles in the file's own units.
  function volumeText(v) {
    if (!v) return 'about 0';
    const logarithm = Math.log10(Math.abs(v)) + 3 * Math.log10(2 * half), exponent = Math.floor(logarithm);
    return (v < 0 ? '-' : '') + (exponent > -5 && exponent < 7 ? Math.pow(10, logarithm).toPrecision(6)
      : Math.pow(10, logarithm - exponent).toFixed(5) + 'e' + exponent);
  }
  function tetText(t) {
    const p = corners(t), angles = dihedralAngles(p);
    const lines = ['tetrahedron ' + tetNumber(t), 'points ' + [0, 1, 2, 3].map(k => pointNumber(tets[4 * t + k])).join(', '),
      'volume ' + volumeText(volume(p)),
      'dihedral angles ' + Math.min(...angles).toPrecision(4) + '\u00b0 to ' + Math.max(...angles).toPrecision(4) + '\u00b0'];
    if (tetRegions.length && scene.regions.length) lines.push('region ' + scene.regions[tetRegions[t]]);
    scene.targets.forEach(target => { if (target.tets.includes(t)) lines.push('named by: ' + target.text); });
    lines.push('(measured by this page in doubles; the verdict is exact)');
    return lines.join('\n');
  }
  const ray = new THREE.Raycaster();
  function pick(x, y) {
    ray.setFromCamera(new THREE.Vector2(2 * x / stage.clientWidth - 1, 1 - 2 * y / stage.clientHeight), camera);
    let best = null;
    const test = (mesh, triangles, tetOf, layer) => {
      for (const hit of ray.intersectObject(mesh, false)) {
        if ((layer.material.clippingPlanes || []).some(plane => plane.distanceToPoint(hit.point) < 0)) continue;
        const through = layer.material.opacity < 1 && !tetOf.length;   // one looks through the translucent surface
        if (!through && (!best || hit.distance < best.hit.distance)) best = {hit, triangles, tetOf, layer};
        if (!through) break;
      }
    };
    for (const layer of layers) if (layer.mesh.visible) test(layer.mesh, layer.triangles, layer.tets, layer);
    if (cut.mesh) test(cut.mesh, cut.triangles, cut.tets, {material: cut.mesh.material, name: 'cut'});
    if (!best) return;
    const i = best.hit.faceIndex, tet = best.tetOf.length ? best.tetOf[i] : -1;
    const v = Array.from(best.triangles.subarray(3 * i, 3 * i + 3));
    if (tet >= 0) select([tet], v, tetText(tet), 'tet ' + tetNumber(tet));
    else select([], v, best.layer.name + '\npoints ' + v.map(pointNumber).filter(n => n >= 0).join(', '), 'triangle');
  }
  let pressed = null;
  renderer.domElement.addEventListener('mousedown', e => { pressed = [e.clientX, e.clientY]; });
  renderer.domElement.addEventListener('mouseup', e => {
    if (!pressed || Math.hypot(e.clientX - pressed[0], e.clientY - pressed[1]) > 4) return;
    const box = renderer.domElement.getBoundingClientRect();
    pick(e.clientX - box.left, e.clientY - box.top);
  });

  // --- flying to a place
  function fly(goal, radius, done) {
    const from = orbit.target.clone(), start = camera.position.clone();
    const end = goal.clone().add(start.clone().sub(from).normalize().multiplyScalar(5 * radius));
    const begin = performance.now();
    (function step() {
      const part = Math.min((performance.now() - begin) / 400, 1), eased = part * part * (3 - 2 * part);
      orbit.target.copy(from).lerp(goal, eased);
      camera.position.copy(start).lerp(end, eased);
      orbit.update();
      draw();
      if (part < 1) requestAnimationFrame(step); else done();
    })();
  }
  for (const button of document.querySelectorAll('[data-target]'))
    button.addEventListener('click', () => {
      const index = Number(button.dataset.target), target = scene.targets[index];
      select(target.tets, target.nodes, target.text, 'flying');
      if (boundary) setOpacity(0.25);
      view.scrollIntoView({block: 'nearest'});
      fly(inUnits(target.middle), Math.max(target.radius / 2 / half, 1e-4),
        () => { view.dataset.selected = 'target ' + index; draw(); });
    });

  // --- controls
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
    const label = element('label', parent, {}), input = element('input', label, Object.assign({type}, attributes));
    label.appendChild(document.createTextNode(' ' + text));
    input.addEventListener('change', () => change(input));
    return input;
  }
  const show = group('Show');
  for (const item of layers.concat(edgeSets))
    choice(show, 'checkbox', Object.assign({id: 'show-' + item.id}, item.wanted ? {checked: ''} : {}), item.name,
      input => { item.wanted = input.checked; showLayers(); });
  if (marks.length) choice(show, 'checkbox', {id: 'show-marks', checked: ''}, 'places', input => { marksShown = input.checked; draw(); });
  let opacityInput = null;
  function setOpacity(value) {
    boundary.material.opacity = value;
    boundary.material.transparent = value < 1;
    boundary.material.depthWrite = value >= 1;
    boundary.mesh.renderOrder = value < 1 ? 1 : 0;
    if (opacityInput) opacityInput.value = value;
    draw();
  }
  if (boundary && boundary.edges)
    choice(show, 'checkbox', {id: 'show-edges', checked: ''}, 'its edges', input => { boundary.edges.visible = input.checked; draw(); });
  if (boundary) {
    element('label', show, {for: 'opacity'}, 'opacity of the boundary');
    opacityInput = element('input', show, {type: 'range', id: 'opacity', min: 0, max: 1, step: 0.05, value: boundary.opacity});
    opacityInput.addEventListener('input', () => setOpacity(Number(opacityInput.value)));
  }
  const offered = Object.keys(colourings).filter(name => colourings[name].usable !== false);
  if (boundary && offered.length > 1) {
    const colours = group('Colour by');
    for (const name of offered)
      choice(colours, 'radio', Object.assign({name: 'colouring', id: 'colour-' + name}, name === colouring ? {checked: ''} : {}), colourings[name].name, () => {
        colouring = name;
        showKey();
        for (const layer of layers) if (layer.coloured) {
          layer.mesh.geometry.dispose();
          layer.mesh.geometry = geometryOf(layer, layer.triangles, layer.tets);
        }
        applyCut();
      });
    const key = element('div', colours, {id: 'key'}), ends = element('div', colours, {id: 'key-ends'});
    for (let i = 0; i < 24; ++i) element('span', key, {}).style.background = '#' + rampColour(i / 23).getHexString();
    const showKey = () => {
      const range = colourings[colouring].ends;
      key.style.display = ends.style.display = range ? '' : 'none';
      ends.textContent = '';
      if (range) for (const end of range) element('span', ends, {}, end);
    };
    showKey();
  }
  if (scene.cut_tets > 0) {
    const cuts = group('Cut: whole tetrahedra behind a plane');
    for (const axis of ['', ...scene.cut_axes])
      choice(cuts, 'radio', Object.assign({name: 'cut', id: 'cut-' + (axis || 'none')}, axis ? {} : {checked: ''}), axis || 'none',
        () => { cut.axis = axis; applyCut(); });
    if (scene.cut_anywhere) {
      const at = element('input', cuts, {type: 'range', id: 'cut-at', min: -0.5, max: 0.5, step: 0.005, value: 0, 'aria-label': 'place of the plane'});
      at.addEventListener('input', () => { cut.at = Number(at.value); if (cut.axis) applyCut(); });
    }
    choice(cuts, 'checkbox', {id: 'cut-flip'}, 'from the other side', input => { cut.flipped = input.checked; if (cut.axis) applyCut(); });
  }
  const home = element('button', controls, {type: 'button', id: 'home'}, 'show all');
  home.addEventListener('click', () => {
    select([], [], '', '');
    if (boundary) setOpacity(scene.layers.find(layer => layer.boundary).opacity);
    fly(new THREE.Vector3(), 0.6 * allRadius, () => {});
  });
  resize();
  showLayers();
})();
