import { expect, test } from 'vitest';
import { clock, readCoordinate, readLink, windOf, writeLink, type Place } from '../../src/place/place';

const place: Place = { x: -2496.25, y: 144, z: 2 ** 35, yaw: 271.5, pitch: -12, time: 17.25, mode: 'walk' };

test('a link opens the same view', () => {
  expect(readLink(writeLink(place))).toEqual(place);
  expect(readLink(writeLink({ ...place, y: null }))).toEqual({ ...place, y: null });
});

test('options of a link stay', () => {
  expect(writeLink(place, '#radius=4')).toContain('radius=4');
});

test('what a link says wrongly is left out', () => {
  expect(readLink('#at=1,2&look=north&time=noon&mode=swim')).toEqual({});
  expect(readLink('#at=1e9,2,3')).toEqual({});
  expect(readLink('#at=,2,3')).toEqual({});
  expect(readLink('#look=-90,400')).toEqual({ yaw: 270, pitch: 90 });
  expect(readLink('#at=999999999999,0,0').x).toBe(2 ** 36 - 1);
  expect(readLink('#%E0%A4%A')).toEqual({});
});

test('coordinates as people write them', () => {
  expect(readCoordinate('100 -200')).toEqual({ x: 100, y: null, z: -200 });
  expect(readCoordinate('100, 64, -200')).toEqual({ x: 100, y: 64, z: -200 });
  expect(readCoordinate('x=1 z=2')).toEqual({ x: 1, y: null, z: 2 });
  expect(readCoordinate('http://a/#at=5,,7&look=1,2')).toEqual({ x: 5, y: null, z: 7 });
  for (const wrong of ['', '1', '1 2 3 4', 'here', '1 999999999999']) expect(readCoordinate(wrong)).toBeNull();
});

test('winds and clock', () => {
  expect([0, 44, 90, 359, 181].map(windOf)).toEqual(['north', 'north-east', 'east', 'north', 'south']);
  expect([0, 6.5, 23.999, 24].map(clock)).toEqual(['00:00', '06:30', '23:59', '00:00']);
});
