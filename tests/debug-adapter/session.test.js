// One debug session, three ways to the target: the answers must be the same.
'use strict';

const assert = require('node:assert/strict');
const path = require('node:path');
const { test, describe, beforeEach, afterEach } = require('node:test');
const { DebugClient } = require('@vscode/debugadapter-testsupport');

const { LATHE, TARGETS, binary, lineOf } = require('./technol.js');

const SPINDLE = path.join(LATHE, 'spindle.plc');
const DEAD_TIME = lineOf(SPINDLE, 'TIM  CNT_DEAD,T_DEAD');

/** Waits for `stopped` and sends what leads to it; the order matters, the event may come first. */
async function stopAfter(client, action) {
  const stopped = client.waitForEvent('stopped', 20000);
  await action();
  return (await stopped).body;
}

async function top(client, threadId) {
  const { body } = await client.stackTraceRequest({ threadId });
  return body.stackFrames[0];
}

async function scope(client, frameId, name) {
  const { body } = await client.scopesRequest({ frameId });
  const found = body.scopes.find((s) => s.name === name);
  assert.ok(found, `scope ${name} among ${body.scopes.map((s) => s.name)}`);
  return found.variablesReference;
}

async function variables(client, variablesReference) {
  const { body } = await client.variablesRequest({ variablesReference });
  return new Map(body.variables.map((v) => [v.name, v]));
}

for (const [way, open] of Object.entries(TARGETS)) {
  const options = way === 'serial line' && process.platform === 'win32' ? { skip: 'needs pseudo terminals' } : {};
  describe(`a debug session over ${way}`, options, () => {
    let client;
    let target;

    beforeEach(async () => {
      target = await open();
      client = new DebugClient(binary('technol'), 'dap', 'technol', { stdio: 'pipe' }, true);
      client.defaultTimeout = 20000;
      await client.start();
    });

    afterEach(async () => {
      await client.stop();
      await target.stop();
    });

    const launch = (more = {}) => ({ program: LATHE, target: target.address, clock: 'virtual', ...more });

    test('stops in a mechanism, steps, sets a value and runs on', async () => {
      // The machine's second block asks for the other direction: the reversal passes the dead time.
      const [stop] = await Promise.all([
        client.waitForEvent('stopped', 20000),
        client.hitBreakpoint(launch(), { path: SPINDLE, line: DEAD_TIME }),
      ]);
      const threadId = stop.body.threadId;
      assert.equal(stop.body.reason, 'breakpoint');
      assert.equal(stop.body.allThreadsStopped, true);

      const { body: threads } = await client.threadsRequest();
      const thread = threads.threads.find((t) => t.id === threadId);
      assert.match(thread.name, /SP_CONTROL/);
      assert.ok(threads.threads.some((t) => /SHOW/.test(t.name)), 'the other running mechanism is a thread');

      const { body: stack } = await client.stackTraceRequest({ threadId });
      assert.equal(stack.stackFrames[0].line, DEAD_TIME);
      assert.match(stack.stackFrames[0].name, /SP_CONTROL/);
      const frameId = stack.stackFrames[0].id;

      const registers = await variables(client, await scope(client, frameId, 'Registers'));
      for (const name of ['RLO', 'DR8', 'DR16', 'DR32', 'DR64', 'DR_REAL']) {
        assert.ok(registers.has(name), `${name} among ${[...registers.keys()]}`);
      }
      const mechanisms = await variables(client, await scope(client, frameId, 'Mechanisms'));
      assert.ok(mechanisms.has('SP_CONTROL') && mechanisms.has('TURRET_CHANGE'));

      const evaluate = async (expression) =>
        (await client.evaluateRequest({ expression, frameId, context: 'watch' })).body.result;
      assert.equal(await evaluate('SP_WANT_CW'), 'false');
      assert.equal(await evaluate('OP0.SP_CCW'), 'false');
      assert.match(await evaluate('SP_TURNS'), /^1\b/);
      assert.match(await evaluate('BYTE.SP_TURNS'), /^1\b/);

      // The dead time waits: `next` stays in the mechanism, which goes on in the next cycle from behind the last
      // EX-type instruction it passed.
      const stepped = await stopAfter(client, () => client.nextRequest({ threadId }));
      assert.equal(stepped.reason, 'step');
      assert.equal(stepped.threadId, threadId);
      assert.equal((await top(client, threadId)).line, DEAD_TIME - 1);

      const set = await client.customRequest('setExpression', {
        expression: 'BLOCKS',
        value: '1234',
        frameId: (await top(client, threadId)).id,
      });
      assert.match(set.body.value, /1234/);
      assert.match(await evaluate('BLOCKS'), /1234/);

      // Nothing else comes by: run on, pause anywhere.
      await client.setBreakpointsRequest({ source: { path: SPINDLE }, breakpoints: [] });
      await client.continueRequest({ threadId });
      const paused = await stopAfter(client, () => client.pauseRequest({ threadId }));
      assert.equal(paused.reason, 'pause');
    });

    test('steps into and out of a procedure', async () => {
      const file = path.join(LATHE, 'turret.plc');
      const call = lineOf(file, 'PROC_CALL TURRET_STEPS');
      const [stop] = await Promise.all([
        client.waitForEvent('stopped', 20000),
        client.hitBreakpoint(launch(), { path: file, line: call }),
      ]);
      const threadId = stop.body.threadId;
      await stopAfter(client, () => client.stepInRequest({ threadId }));
      const { body: inside } = await client.stackTraceRequest({ threadId });
      assert.match(inside.stackFrames[0].name, /TURRET_STEPS/);
      assert.ok(inside.stackFrames.length >= 2, 'the caller is on the stack');
      await stopAfter(client, () => client.stepOutRequest({ threadId }));
      assert.ok((await top(client, threadId)).line > call);
    });

    test('stops on entry, takes break-points while running and terminates', async () => {
      const stopped = client.waitForEvent('stopped', 20000);
      await Promise.all([client.configurationSequence(), client.launch(launch({ stopOnEntry: true }))]);
      const entry = await stopped;
      assert.equal(entry.body.reason, 'entry');
      await client.continueRequest({ threadId: entry.body.threadId });

      const file = path.join(LATHE, 'panel.plc');
      const line = lineOf(file, 'TIM  -,50');
      const hit = await stopAfter(client, async () => {
        const { body } = await client.setBreakpointsRequest({ source: { path: file }, breakpoints: [{ line }] });
        assert.equal(body.breakpoints[0].verified, true);
      });
      assert.equal(hit.reason, 'breakpoint');

      const terminated = client.waitForEvent('terminated', 20000);
      await client.terminateRequest();
      await terminated;
    });

    test('answers what cannot be done with a reason', async () => {
      await client.initializeRequest();
      await assert.rejects(client.threadsRequest().then(() => client.stackTraceRequest({ threadId: 1 })));
      await assert.rejects(
        client.launchRequest({ program: path.join(LATHE, 'no-such-folder'), target: target.address }),
        /no-such-folder/,
      );
      await assert.rejects(client.customRequest('noSuchRequest'), /noSuchRequest/);
    });
  });
}
