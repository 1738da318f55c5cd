// talus-client's look_test.cpp has the same numbers: both read client_sample/look.json.
import { expect, test } from 'vitest';
import { materialTexture } from '../../src/engine/draw/materials';
import { lightAt } from '../../src/engine/draw/sun';

const material = (id: number, name: string, colour: number) => ({ id, name, colour, phase: 'solid' as const });

test('turf is greyer under the sun than on a map, and snow darker; leaves are as they are', () => {
  const data = materialTexture([material(0, 'Grass', 0x6fa845), material(1, 'snow', 0xffffff), material(2, 'forest needles', 0x6fa845)] as never).image.data as Float32Array;
  const wanted = [
    [0.1735, 0.3361, 0.0869],
    [0.8, 0.83, 0.87],
    [0.159, 0.3916, 0.0595],
  ];
  wanted.forEach((rgb, i) => rgb.forEach((value, channel) => expect(data[i * 8 + channel]).toBeCloseTo(value, 3)));
});

test('the light is that of the hour', () => {
  const noon = lightAt(12);
  expect(noon.exposure).toBeLessThan(0.75);
  expect(noon.exposure).toBeGreaterThan(0.69);
  expect(lightAt(0).exposure).toBeCloseTo(2.1);
  expect(noon.sunLight.x).toBeGreaterThan(4.3);
});
