// The viewer in a browser, on a real talusd: about a minute.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { addressFollows, filled, launch, newPage, noProblems, place, SMALL, stats } from './browser.mjs';
import { landSeen } from './land_seen.mjs';
import { readNpy } from './npy.mjs';
import { scratch, startSite, talusGen } from './talusd.mjs';

test('a page of a real talusd', async (t) => {
  const site = await startSite(t);
  const browser = await launch(t);
  const page = await newPage(browser);
  await page.goto(`${site.url}#${SMALL}`);
  await filled(page);

  await t.test('the view fills', async () => {
    const { chunks, meshes, triangles } = await stats(page);
    assert.ok(chunks >= 49, `${chunks} chunks`);
    assert.ok(meshes > 0, `${meshes} meshes`);
    assert.ok(triangles > 1000 && triangles < 300_000, `${triangles} triangles`);
    await page.waitForFunction(() => document.getElementById('status-text').textContent === 'All here');
    assert.equal(await page.locator('#opening.gone').count(), 1);
    assert.ok(await page.locator('#notice').isHidden());
  });

  await t.test('voxels are those of talus-gen export', async (t) => {
    const spawn = await page.evaluate(() => window.talus.engine.world.spawn);
    const origin = { x: spawn.x - 32, z: spawn.z - 32 };
    const folder = scratch(t);
    talusGen('export', '--origin', `${origin.x},${origin.z}`, '--size', '64,64', '-o', folder);
    const { shape, values } = readNpy(`${folder}/voxels.npy`);
    const { y0 } = JSON.parse(readFileSync(`${folder}/export.json`, 'utf8'));
    const [rows, depth, width] = shape;
    const low = Math.max(y0, spawn.y - 24);
    const high = spawn.y + 24;
    const seen = await page.evaluate(
      ([{ x, z }, low, high, width, depth]) => {
        const { engine } = window.talus;
        const all = [];
        for (let y = low; y < high; ++y)
          for (let dz = 0; dz < depth; ++dz) for (let dx = 0; dx < width; ++dx) all.push(engine.voxelAt(x + dx, y, z + dz) ?? -1);
        return all;
      },
      [origin, low, high, width, depth],
    );
    const wrong = [];
    seen.forEach((id, i) => {
      const [dx, dz, y] = [i % width, Math.floor(i / width) % depth, low + Math.floor(i / (width * depth))];
      const expected = y - y0 < rows ? values[((y - y0) * depth + dz) * width + dx] : 0;
      if (id !== expected) wrong.push(`${origin.x + dx},${y},${origin.z + dz}: ${id}, not ${expected}`);
    });
    assert.deepEqual(wrong.slice(0, 5), [], `${wrong.length} of ${seen.length} voxels differ`);

    await t.test('and so are those that are picked', async () => {
      const { materials } = JSON.parse(readFileSync(`${folder}/export.json`, 'utf8'));
      await page.evaluate(() => {
        window.talus.player.body.pitch = -60;
      });
      let picked = 0;
      for (const [x, y] of [[160, 120], [100, 140], [210, 160], [160, 190], [120, 90]]) {
        await page.evaluate(() => new Promise(requestAnimationFrame));
        await page.evaluate(([x, y]) => window.talus.pick(x, y), [x, y]);
        if (await page.locator('#voxel').isHidden()) continue;
        const [vx, vy, vz] = (await page.locator('#voxel-at').textContent()).split(',').map(Number);
        const [dx, dz] = [vx - origin.x, vz - origin.z];
        if (dx < 0 || dz < 0 || dx >= width || dz >= depth) continue;
        const id = values[((vy - y0) * depth + dz) * width + dx];
        assert.equal(await page.locator('#voxel-name').textContent(), materials.find((m) => m.id === id).name);
        ++picked;
      }
      assert.ok(picked >= 2, `${picked} voxels were picked`);
    });
  });

  await t.test('the address opens the same view', async () => {
    await page.evaluate(() => {
      const { body } = window.talus.player;
      body.place(body.position[0] + 7.25, body.position[1] + 3, body.position[2] - 5.5);
      body.yaw = 123.4;
      body.pitch = -21.5;
    });
    await page.keyboard.press('Period');
    await addressFollows(page);
    await page.waitForFunction(() => /look=123\.4,-21\.5&time=10\.75/.test(location.hash));
    const other = await newPage(browser);
    await other.goto(page.url());
    await filled(other);
    assert.deepEqual(await place(other), await place(page));
    assert.equal(await other.evaluate(() => document.getElementById('time-now').textContent), '10:45');
    noProblems(other);
    await other.context().close();
  });

  await t.test('the land is drawn without holes', async () => {
    await page.evaluate(() => {
      window.talus.player.body.pitch = -20;
    });
    const size = page.viewportSize();
    const { skyline, holes } = await landSeen(page, size);
    const shown = skyline.reduce((sum, y) => sum + size.height - y, 0);
    assert.ok(shown > (size.width * size.height) / 4, `${shown} pixels of land`);
    // One sees sky between the leaves of trees.
    assert.ok(holes.length < shown / 200, `one looks through the land at ${holes.length} of ${shown} pixels`);
  });

  noProblems(page);
});
