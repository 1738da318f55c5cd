import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { documents, faults, filesBelow, root } from './manifests.mjs';

const cluster = filesBelow('docker/kubernetes/cluster').flatMap(documents);
const one = (kind, name) => {
  const found = cluster.filter((manifest) => manifest.kind === kind && manifest.metadata.name === name);
  assert.equal(found.length, 1, `${kind} ${name}`);
  return found[0];
};
const pods = cluster.filter((manifest) => manifest.spec?.template?.spec).map((manifest) => [manifest, manifest.spec.template.spec]);

for (const path of filesBelow('docker/kubernetes')) {
  if (path.endsWith('adapter-values.yaml')) continue;
  test(`${path} is as Kubernetes' types have it`, () => {
    for (const manifest of documents(path)) assert.deepEqual(faults(manifest), [], `${manifest.kind} ${manifest.metadata.name}`);
  });
}

test('the check finds what is wrong', () => {
  const broken = (change) => {
    const manifest = structuredClone(one('StatefulSet', 'talus'));
    change(manifest);
    return faults(manifest);
  };
  assert.deepEqual(broken(() => {}), []);
  assert.match(broken((m) => { m.spec.replicaCount = 3; }).join(), /\/spec\/replicaCount: unknown/);
  assert.match(broken((m) => { m.spec.template.spec.containers[0].imagee = 'x'; }).join(), /containers\/0\/imagee: unknown/);
  assert.match(broken((m) => { m.spec.template.spec.topologySpreadConstraints[0].maxSkew = 'one'; }).join(), /maxSkew: type .*integer/);
  assert.match(broken((m) => { m.metadata.anotations = {}; }).join(), /\/metadata\/anotations: unknown/);
  assert.match(broken((m) => { delete m.spec.template.spec.containers; }).join(), /required .*containers/);
  const policy = structuredClone(one('NetworkPolicy', 'talus'));
  policy.spec.ingress[0].port = 1;
  assert.match(faults(policy).join(), /ingress\/0\/port: unknown/);
});

test('what pods, services, claims and policies name is there', () => {
  const secrets = new Set(['nats-tls', 'talus', 'talusd-tls', 'talus-admin-tls']);
  const texts = filesBelow('docker/kubernetes/cluster').map((path) => readFileSync(join(root, path), 'utf8')).join('');
  for (const secret of secrets) assert.match(texts, new RegExp(`create secret generic ${secret} `), secret);
  for (const [manifest, pod] of pods) {
    const volumes = new Set([...(pod.volumes ?? []), ...(manifest.spec.volumeClaimTemplates ?? []).map((c) => c.metadata)].map((v) => v.name));
    for (const volume of pod.volumes ?? []) {
      if (volume.secret) assert.ok(secrets.has(volume.secret.secretName), volume.name);
      if (volume.configMap) one('ConfigMap', volume.configMap.name);
    }
    for (const container of pod.containers) {
      for (const mount of container.volumeMounts ?? []) assert.ok(volumes.has(mount.name), `${container.name}: ${mount.name}`);
      for (const from of container.envFrom ?? []) one('ConfigMap', from.configMapRef.name);
      const ports = new Set(pod.containers.flatMap((c) => (c.ports ?? []).map((p) => p.name)));
      for (const probe of ['startupProbe', 'readinessProbe', 'livenessProbe']) {
        if (container[probe]) assert.ok(ports.has(container[probe].httpGet.port), `${container.name} ${probe}`);
      }
    }
    if (manifest.kind === 'StatefulSet') one('Service', manifest.spec.serviceName);
    assert.deepEqual(manifest.spec.template.metadata.labels, manifest.spec.selector?.matchLabels ?? manifest.spec.template.metadata.labels);
  }
  const apps = new Map(pods.map(([manifest, pod]) => [manifest.spec.template.metadata.labels.app, pod]));
  for (const service of cluster.filter((m) => m.kind === 'Service')) {
    const names = apps.get(service.spec.selector.app).containers.flatMap((c) => c.ports.map((p) => p.name));
    for (const port of service.spec.ports) assert.ok(names.includes(port.targetPort), `${service.metadata.name}: ${port.targetPort}`);
  }
  for (const policy of cluster.filter((m) => m.kind === 'NetworkPolicy')) {
    const pod = apps.get(policy.spec.podSelector.matchLabels.app);
    const names = pod.containers.flatMap((c) => (c.ports ?? []).map((p) => p.name));
    for (const { ports } of policy.spec.ingress ?? []) for (const { port } of ports) assert.ok(names.includes(port), `${policy.metadata.name}: ${port}`);
  }
  const scaler = one('HorizontalPodAutoscaler', 'talus');
  one(scaler.spec.scaleTargetRef.kind, scaler.spec.scaleTargetRef.name);
});

test('pods are not root, write only their volumes, and know no token of the API', () => {
  for (const [manifest, pod] of pods) {
    assert.equal(pod.automountServiceAccountToken, false, manifest.metadata.name);
    assert.equal(pod.securityContext.runAsNonRoot, true);
    assert.ok(pod.securityContext.runAsUser > 0);
    for (const container of pod.containers) {
      assert.deepEqual(container.securityContext, { allowPrivilegeEscalation: false, readOnlyRootFilesystem: true, capabilities: { drop: ['ALL'] } });
      assert.ok(container.resources.limits.memory, container.name);
    }
  }
});

test('two servers with disks are there at least, on two hosts, and three of the log on three', () => {
  const talus = one('StatefulSet', 'talus');
  assert.ok(one('HorizontalPodAutoscaler', 'talus').spec.minReplicas >= 2);
  assert.equal(talus.spec.replicas, undefined);
  assert.equal(talus.spec.volumeClaimTemplates.length, 1);
  assert.equal(talus.spec.persistentVolumeClaimRetentionPolicy.whenScaled, 'Retain');
  const spread = talus.spec.template.spec.topologySpreadConstraints[0];
  assert.deepEqual([spread.topologyKey, spread.minDomains, spread.whenUnsatisfiable], ['kubernetes.io/hostname', 2, 'DoNotSchedule']);
  const nats = one('StatefulSet', 'nats');
  assert.equal(nats.spec.replicas, 3);
  const apart = nats.spec.template.spec.affinity.podAntiAffinity.requiredDuringSchedulingIgnoredDuringExecution[0];
  assert.equal(apart.topologyKey, 'kubernetes.io/hostname');
  for (const name of ['talus', 'nats']) assert.equal(one('PodDisruptionBudget', name).spec.maxUnavailable, 1);
});

test('a pod has time for its lead and its drain', () => {
  const settings = one('ConfigMap', 'talus').data;
  const needed = Number(settings.TALUS_SHUTDOWN_LEAD_MS) + Number(settings.TALUS_SHUTDOWN_DRAIN_MS);
  assert.ok(one('StatefulSet', 'talus').spec.template.spec.terminationGracePeriodSeconds * 1000 > needed + 5000);
});

test("NATS' files are those of docker/nats, with the pods' names", () => {
  const data = one('ConfigMap', 'nats').data;
  const shipped = (name) => readFileSync(join(root, 'docker/nats', name), 'utf8');
  assert.equal(data['permissions.conf'], shipped('permissions.conf'));
  assert.equal(data['nats-server.conf'], shipped('nats-server.conf').replaceAll(/"tls:\/\/(nats-\d):6222"/g, '"tls://$1.nats:6222"'));
  for (let i = 0; i < 3; ++i) assert.ok(data['nats-server.conf'].includes(`tls://nats-${i}.nats:6222`));
});

test('the autoscaler asks for the metric that the adapter makes', () => {
  const [values] = documents('docker/kubernetes/adapter-values.yaml');
  const [rule] = values.rules.custom;
  assert.equal(rule.name.as, one('HorizontalPodAutoscaler', 'talus').spec.metrics[0].pods.metric.name);
  assert.ok(new RegExp(rule.name.matches).test(/^[a-z_]+/.exec(rule.seriesQuery)[0]));
});
