// SPDX-License-Identifier: BSD-3-Clause
// Vectors of three numbers, as plain arrays.

export const radians = Math.PI / 180;

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (a, factor) => [a[0] * factor, a[1] * factor, a[2] * factor];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const divide = (a, b) => [a[0] / b[0], a[1] / b[1], a[2] / b[2]];
export const length = (a) => Math.sqrt(dot(a, a));
export const clamp = (value, least, most) => Math.min(Math.max(value, least), most);
