// SPDX-License-Identifier: BSD-3-Clause
// Starts the page.
import { connectControls, find, togglePanel } from './controls.js';
import { whatIsMissing } from './graphics.js';
import { watchKeys, watchPointers } from './pointer.js';
import { ScenePicture } from './scenePicture.js';
import { EmbeddedSeries, FolderSeries } from './series.js';
import { bytesOfBase64, inflate } from './unpacking.js';
import { Viewer } from './viewer.js';


function report(text) {
  find('message').textContent = text;
  find('message').hidden = text === '';
}

async function readScene() {
  const [text, groundTexels] = await Promise.all(['scene', 'ground'].map((id) => inflate(bytesOfBase64(find(id).textContent))));
  return { ...JSON.parse(new TextDecoder().decode(text)), groundTexels };
}

async function loadFaces() {
  for (const [id, weight] of [['letters', 'normal'], ['bold-letters', 'bold']]) {
    const face = new FontFace('Inter', await inflate(bytesOfBase64(find(id).textContent)), { weight });
    document.fonts.add(await face.load());
  }
}

function readShaders() {
  return Object.fromEntries([...document.querySelectorAll('script[data-shader]')]
    .map((element) => [element.dataset.shader, element.textContent]));
}

async function openSeries(scene) {
  if (scene.series === null) {
    return new EmbeddedSeries(scene, document);
  }
  if (location.protocol === 'file:') {
    throw new Error('This page reads volume files beside it, which browsers allow on a server alone: put the folder on a web ' +
      'server, or run "python3 -m http.server" in it. A page that opens by itself is made with -o storm.html.');
  }
  const series = new FolderSeries(scene, (name, options) => fetch(name, options));
  await series.refresh();
  return series;
}

// Words after # in the address: time, azimuth, tilt, zoom, preset, and controls=0 for the picture alone.
function applyAddress(scene, words) {
  for (const name of ['azimuth', 'tilt', 'zoom']) {
    const value = Number(words.get(name));
    if (words.has(name) && Number.isFinite(value)) {
      scene.camera[name] = value;
    }
  }
  scene.camera.parallel = words.get('parallel') === '1' || scene.camera.parallel;
  const preset = scene.presets.findIndex(({ name }) => name === words.get('preset'));
  scene.preset = preset >= 0 ? preset : scene.preset;
  document.body.classList.toggle('bare', words.get('controls') === '0');
}

function followSize(viewer) {
  const box = find('view');
  const resize = () => viewer.resize(box.clientWidth, box.clientHeight, window.devicePixelRatio || 1);
  new ResizeObserver(resize).observe(box);
  resize();
}

function followSeries(viewer, series) {
  let newest = viewer.isNewest(); // as it was before the series changed
  viewer.whenChanged(() => {
    newest = viewer.isNewest();
  });
  series.follow(() => viewer.grow(newest), (problem) => report(problem.message));
}

async function start() {
  const missing = whatIsMissing(window);
  if (missing !== null) {
    throw new Error(missing);
  }
  const scene = await readScene();
  const words = new URLSearchParams(location.hash.slice(1));
  applyAddress(scene, words);
  await loadFaces();
  const series = await openSeries(scene);
  const picture = new ScenePicture(scene, find('picture'), find('letters-over'), readShaders());
  const viewer = new Viewer(scene, series, picture, report);
  viewer.position = Math.min(Math.max(Number(words.get('time') ?? 0) || 0, 0), series.times.length - 1);
  followSize(viewer);
  connectControls(viewer);
  watchPointers(find('picture'), viewer);
  watchKeys(document, viewer, togglePanel);
  await viewer.start();
  followSeries(viewer, series);
  find('picture').addEventListener('webglcontextlost', () =>
    report('The graphics card was taken away from this page. Load the page again.'));
  window.nexrad3d = viewer; // for tests and for the console
}

start().catch((problem) => report(problem.message));
