// SPDX-License-Identifier: BSD-3-Clause
// The controls of the page: they change the viewer, and show what it does.
import { namesOf, timeText } from './captions.js';

export const find = (id) => document.getElementById(id);

function fillPresets(viewer) {
  for (const [index, { name }] of viewer.scene.presets.entries()) {
    find('preset').add(new Option(name, index));
  }
}

function prepareSurface(viewer) {
  const { bins, labels } = viewer.scene.presets[0];
  const valueOf = ({ from }) => (from - labels.offset) / labels.factor;
  const [low, high] = [viewer.scene.floor ?? valueOf(bins[0]), valueOf(bins[bins.length - 1])];
  Object.assign(find('surface-value'), { min: low, max: high, step: (high - low) / 140, value: low + 0.6 * (high - low) });
}

function surfaceOf() {
  return find('surface').checked ? Number(find('surface-value').value) : null;
}

function cutOf() {
  return find('cut').checked
    ? { azimuth: Number(find('cut-azimuth').value), offset: Number(find('cut-offset').value) / 100 }
    : null;
}

function connectLook(viewer) {
  find('preset').onchange = () => viewer.set({ preset: Number(find('preset').value) });
  find('strength').oninput = () => viewer.set({ strength: 2 ** Number(find('strength').value) });
  for (const id of ['surface', 'surface-value']) {
    find(id).oninput = () => viewer.set({ surface: surfaceOf() });
  }
  for (const id of ['cut', 'cut-azimuth', 'cut-offset']) {
    find(id).oninput = () => viewer.set({ cut: cutOf() });
  }
  find('stretch').oninput = () => viewer.set({ stretch: Number(find('stretch').value) });
  find('turning').onchange = () => viewer.set({ turning: find('turning').checked });
}

function connectTime(viewer) {
  find('play').onclick = () => viewer.play(!viewer.playing);
  find('back').onclick = () => viewer.step(-1);
  find('on').onclick = () => viewer.step(1);
  find('time').oninput = () => {
    viewer.play(false);
    viewer.showPosition(Number(find('time').value));
  };
  find('speed').onchange = () => viewer.set({ speed: Number(find('speed').value) });
  find('blend').onchange = () => viewer.set({ blend: find('blend').checked });
  find('reset').onclick = () => viewer.reset();
}

// What the viewer does, as the controls show it.
function follow(viewer) {
  const { settings, series, scene } = viewer;
  const index = Math.floor(viewer.position);
  const say = (id, text) => {
    if (find(id).textContent !== text) {
      find(id).textContent = text;
    }
  };
  find('time').max = series.times.length - 1;
  find('time').value = index;
  find('time').setAttribute('aria-valuetext', timeText(series.times[index]));
  say('clock', `${timeText(series.times[index])} (${index + 1} of ${series.times.length})`);
  find('play').setAttribute('aria-label', viewer.playing ? 'Pause' : 'Play');
  find('play').dataset.playing = viewer.playing;
  find('preset').value = settings.preset;
  find('surface').checked = settings.surface !== null;
  find('turning').checked = settings.turning;
  find('stretch').value = settings.stretch;
  say('stretch-text', `${settings.stretch} times`);
  say('strength-text', `${Math.round(100 * settings.strength)} %`);
  say('surface-text', `${Number(find('surface-value').value).toPrecision(3)} ${scene.unit}`);
  say('cut-azimuth-text', `${find('cut-azimuth').value}°`);
  const word = scene.synthetic ? 'SYNTHETIC. ' : '';
  find('picture').setAttribute('aria-label',
    `${word}${scene.title} of ${namesOf(scene.sites).join(', ')} at ${timeText(series.times[index])}, in three dimensions`);
}

export function togglePanel() {
  find('panel').hidden = !find('panel').hidden;
  find('settings').setAttribute('aria-expanded', String(!find('panel').hidden));
}

export function connectControls(viewer) {
  fillPresets(viewer);
  prepareSurface(viewer);
  connectLook(viewer);
  connectTime(viewer);
  find('settings').onclick = togglePanel;
  viewer.whenChanged(() => follow(viewer));
}
