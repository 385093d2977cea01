// The page's view: draws the scene with three.js, turns it, cuts it, and answers clicks. Without WebGL the picture and
// the tables stay as they are. Nothing of the scene's texts becomes markup: they are set as text.
'use strict';
const viewer = (function () {
  const byId = id => document.getElementById(id);
  const view = byId('view'), stage = byId('stage'), told = byId('told');
  const {scene, decode, pointNumber, place, toUnits, radius, half} = model;
  const {valuesOf, geometryOf, linesOf, sidesOf, facesOfTets, meshOf} = drawing;
  const inUnits = p => new THREE.Vector3(toUnits(p[0], 0), toUnits(p[1], 1), toUnits(p[2], 2));

  // --- without WebGL all else stays
  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
  } catch (error) {
    byId('no-view').textContent = 
      'This browser shows no WebGL: the picture stands for the view. All tables are complete.';
    for (const button of document.querySelectorAll('button[data-target]')) button.disabled = true;
    view.dataset.ready = 'without';
    return null;
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
  // How far from the middle, in this direction, the camera has everything in view.
  function distanceForAll(away) {
    const towards = away.clone().normalize();
    const right = new THREE.Vector3().crossVectors(camera.up, towards).normalize();
    const up = new THREE.Vector3().crossVectors(towards, right);
    const slope = Math.tan(camera.fov / 2 * Math.PI / 180);
    const aspect = stage.clientWidth / Math.max(stage.clientHeight, 1);
    const p = new THREE.Vector3();
    let distance = 0;
    for (let i = 0; i < place.length; i += 3) {
      p.set(place[i], place[i + 1], place[i + 2]);
      const reach = Math.max(Math.abs(p.dot(right)) / aspect, Math.abs(p.dot(up)));
      distance = Math.max(distance, p.dot(towards) + reach / slope);
    }
    return 1.08 * distance || 1;
  }
  camera.position.set(2.2, -3.2, 1.6);
  camera.position.setLength(distanceForAll(camera.position));
  world.add(camera);
  world.add(new THREE.AmbientLight(0xffffff, 0.55));
  const lamp = new THREE.DirectionalLight(0xffffff, 0.6);
  lamp.position.set(0.3, 0.5, 1);
  camera.add(lamp);
  const orbit = new THREE.OrbitControls(camera, renderer.domElement);
  orbit.enableKeys = false;   // they would only pan; see below
  orbit.addEventListener('change', draw);

  // --- layers of triangles
  let colouring = 'plain';
  function makeLayer(given, index) {
    const layer = {
      id: given.id, name: given.name, plain: new THREE.Color(given.colour), boundary: given.boundary,
      triangles: decode(given.triangles, Int32Array), tets: decode(given.tets, Int32Array), values: valuesOf[index],
      wanted: given.shown, coloured: given.boundary, opacity: given.opacity,
    };
    const ids = decode(given.faces, Uint32Array);
    if (ids.length) {
      layer.tets = Int32Array.from(ids, id => id >>> 2);
      layer.triangles = facesOfTets(ids);
    }
    layer.mesh = meshOf(geometryOf(layer, layer.triangles, layer.tets), 2 + scene.layers.length - index,
      {transparent: given.opacity < 1, opacity: given.opacity, depthWrite: given.opacity >= 1});
    layer.material = layer.mesh.material;
    layer.mesh.renderOrder = given.opacity < 1 ? 2 : 0;
    if (given.boundary && layer.tets.length <= 60000) layer.mesh.add(layer.edges = sidesOf(layer.triangles, '#46505a'));
    fadeEdges(layer);
    world.add(layer.mesh);
    return layer;
  }
  const layers = scene.layers.map(makeLayer);
  const edgeSets = scene.edges.map(given => {
    const lines = linesOf(decode(given.edges, Int32Array), given.colour);
    world.add(lines);
    return {id: given.id, name: given.name, mesh: lines, wanted: given.shown};
  });
  const boundary = layers.find(layer => layer.boundary);

  // --- the cut
  const cut = {axis: '', at: 0, flipped: false, mesh: null, count: 0,
    triangles: new Int32Array(0), tets: new Int32Array(0)};
  const axisOf = {x: 0, y: 1, z: 2};
  // At first the half behind the plane, as one sees it, is kept: the view begins from +x, -y and +z.
  function flipped() { return cut.flipped !== (cut.axis === 'y'); }
  function planePlace() {
    const k = axisOf[cut.axis];
    return scene.cut_anywhere ? cut.at : toUnits(scene.cut_middle[k], k);
  }
  function computeCut() {
    if (cut.mesh) { world.remove(cut.mesh); cut.mesh.geometry.dispose(); cut.mesh = null; }
    cut.triangles = cut.tets = new Int32Array(0);
    if (!cut.axis) return;
    Object.assign(cut, tetsBehind(axisOf[cut.axis], planePlace(), flipped() ? -1 : 1));
    cut.mesh = meshOf(geometryOf({plain: new THREE.Color('#e9c46a')}, cut.triangles, cut.tets, colouring), 2);
    cut.mesh.add(sidesOf(cut.triangles, '#2b3137'));
    world.add(cut.mesh);
  }
  // Where the whole mesh can be cut, the cut takes the boundary's place; else the plane cuts the boundary
  // and the surface.
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
    for (const layer of layers)
      layer.mesh.visible = layer.wanted && !(layer.boundary && cut.axis && scene.cut_anywhere);
    for (const edges of edgeSets) edges.mesh.visible = edges.wanted;
    draw();
  }
  function colourBy(name) {
    colouring = name;
    for (const layer of layers) if (layer.coloured) {
      layer.mesh.geometry.dispose();
      layer.mesh.geometry = geometryOf(layer, layer.triangles, layer.tets, colouring);
    }
    applyCut();
  }
  // Through a translucent boundary one sees the edges of both sides: faint ones leave its inside visible.
  function fadeEdges(layer) {
    if (!layer.edges) return;
    layer.edges.material.transparent = layer.opacity < 1;
    layer.edges.material.opacity = layer.opacity < 1 ? 0.3 : 1;
  }
  function setOpacity(value) {
    boundary.opacity = value;
    boundary.material.opacity = value;
    boundary.material.transparent = value < 1;
    boundary.material.depthWrite = value >= 1;
    boundary.mesh.renderOrder = value < 1 ? 1 : 0;
    fadeEdges(boundary);
    view.dispatchEvent(new Event('opacity'));
    draw();
  }

  let asked = false;
  function draw() {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      // Depths are told apart best around the target.
      const distance = camera.position.distanceTo(orbit.target);
      camera.near = distance / 500;
      camera.far = distance + 4 * radius;
      camera.updateProjectionMatrix();
      renderer.render(world, camera);
      overlay.place(camera);
      tellState();
    });
  }
  // What is seen, for those who cannot see it: tests, mostly.
  function tellState() {
    view.dataset.ready = 'yes';
    view.dataset.cutTets = cut.axis ? cut.count : 0;
    view.dataset.cutTriangles = cut.tets.length;
    view.dataset.target = orbit.target.toArray().map(c => c.toFixed(6)).join(' ');
    view.dataset.camera = camera.position.toArray().map(c => c.toFixed(6)).join(' ');
    view.dataset.distance = camera.position.distanceTo(orbit.target).toPrecision(6);
    view.dataset.shown = layers.concat(edgeSets).filter(one => one.mesh.visible).map(one => one.id).join(' ');
    view.dataset.colouring = colouring;
  }
  function resize() {
    const width = stage.clientWidth, height = stage.clientHeight;
    renderer.setSize(width, height);
    camera.aspect = width / Math.max(height, 1);
    draw();
  }
  window.addEventListener('resize', resize);

  // --- what was chosen: in a colour of its own, seen through everything, and words
  let chosen = null;
  function select({tets: list = [], faces: triangles = [], nodes = []}, text, kind) {
    if (chosen) world.remove(chosen);
    chosen = new THREE.Group();
    const add = (object, order) => { object.renderOrder = order; chosen.add(object); };
    const ids = [];
    for (const t of list) ids.push(4 * t, 4 * t + 1, 4 * t + 2, 4 * t + 3);
    const all = Int32Array.from([...facesOfTets(ids), ...triangles.flat()]);
    if (all.length) {
      const body = meshOf(geometryOf({plain: new THREE.Color('#ffd21f')}, all, []), 0,
        {transparent: true, opacity: 0.75, depthWrite: false});
      const lines = sidesOf(all, '#000000');
      lines.material.depthTest = false;
      add(body, 3);
      add(lines, 9);
    }
    const dots = new THREE.Points(new THREE.BufferGeometry(),
      new THREE.PointsMaterial({color: '#000000', size: 7, sizeAttenuation: false, depthTest: false}));
    const at = new Float32Array(3 * nodes.length);
    nodes.forEach((v, i) => at.set(place.subarray(3 * v, 3 * v + 3), 3 * i));
    dots.geometry.setAttribute('position', new THREE.BufferAttribute(at, 3));
    add(dots, 9);
    world.add(chosen);
    told.textContent = text;
    view.dataset.selected = kind;
    draw();
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
    if (tet >= 0) select({tets: [tet], nodes: v}, model.tetText(tet), 'tet ' + model.tetNumber(tet));
    else select({faces: [v], nodes: v},
      best.layer.name + '\npoints ' + v.map(pointNumber).filter(n => n >= 0).join(', '), 'triangle');
  }
  let pressed = null;
  renderer.domElement.addEventListener('pointerdown', e => { pressed = [e.clientX, e.clientY]; });
  renderer.domElement.addEventListener('pointerup', e => {
    if (!pressed || Math.hypot(e.clientX - pressed[0], e.clientY - pressed[1]) > 4) return;
    const box = renderer.domElement.getBoundingClientRect();
    pick(e.clientX - box.left, e.clientY - box.top);
  });
  // By keyboard: arrows turn, + and - zoom.
  renderer.domElement.tabIndex = 0;
  renderer.domElement.setAttribute('aria-label', 'the mesh; arrow keys turn it, plus and minus zoom');
  renderer.domElement.addEventListener('keydown', e => {
    const turns = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[e.key];
    const zoom = {'+': 0.8, '=': 0.8, '-': 1.25}[e.key];
    if ((!turns && !zoom) || e.ctrlKey || e.metaKey || e.altKey) return;
    e.preventDefault();
    const away = camera.position.clone().sub(orbit.target);
    if (zoom) away.multiplyScalar(zoom);
    if (turns) {
      // The poles of three.js are y.
      const spherical = new THREE.Spherical().setFromVector3(new THREE.Vector3(away.x, away.z, -away.y));
      spherical.theta += 0.1 * turns[0];
      spherical.phi = Math.min(Math.max(spherical.phi + 0.1 * turns[1], 0.01), Math.PI - 0.01);
      const turned = new THREE.Vector3().setFromSpherical(spherical);
      away.set(turned.x, -turned.z, turned.y);
    }
    camera.position.copy(orbit.target).add(away);
    orbit.update();
    draw();
  });

  // --- flying to a place
  function fly(goal, distance, done) {
    const from = orbit.target.clone(), start = camera.position.clone();
    const end = goal.clone().add(start.clone().sub(from).setLength(distance));
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
  for (const button of document.querySelectorAll('button[data-target]'))
    button.addEventListener('click', () => {
      const index = Number(button.dataset.target), target = scene.targets[index];
      select(target, target.text, 'flying');
      if (boundary) setOpacity(0.25);
      stage.scrollIntoView({block: 'nearest'});
      fly(inUnits(target.middle), 5 * Math.max(target.radius / 2 / half, 1e-4),
        () => { view.dataset.selected = 'target ' + index; draw(); });
    });
  function showAll() {
    select({}, '', '');
    if (boundary) setOpacity(scene.layers.find(layer => layer.boundary).opacity);
    fly(new THREE.Vector3(), distanceForAll(camera.position.clone().sub(orbit.target)), () => {});
  }
  return {
    layers, edgeSets, boundary, cut, draw, showLayers, colourBy, applyCut, setOpacity, showAll,
    showMarks: shown => { overlay.marksShown = shown; draw(); },
    start: () => { resize(); showLayers(); },
    // In the file's own unit; nothing while there is no cut.
    planeText: () => cut.axis
      ? cut.axis + ' = ' + Number(model.toFile(planePlace(), axisOf[cut.axis]).toPrecision(6)) : '',
  };
})();
