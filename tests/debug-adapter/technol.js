// Starting what the sessions need: the binary, targets on TCP and on a pair of pseudo terminals.
'use strict';

const { spawn, execFileSync } = require('node:child_process');
const fs = require('node:fs');
const path = require('node:path');

const ROOT = path.resolve(__dirname, '..', '..');
const LATHE = path.join(ROOT, 'examples', 'lathe');

/** Folder with the debug build, wherever the target directory is. */
function binaries() {
  const metadata = JSON.parse(
    execFileSync('cargo', ['metadata', '--format-version=1', '--no-deps', '--offline'], {
      cwd: ROOT,
      maxBuffer: 64 << 20,
    }),
  );
  return path.join(metadata.target_directory, 'debug');
}

/** Path of a binary of the workspace; a clear error when it was not built. */
function binary(name) {
  const file = path.join(binaries(), process.platform === 'win32' ? `${name}.exe` : name);
  if (!fs.existsSync(file)) {
    throw new Error(`${file} is missing: run \`cargo build --workspace\` first`);
  }
  return file;
}

/** 1-based line of the only line of `file` that holds `text`. */
function lineOf(file, text) {
  const lines = fs.readFileSync(file, 'utf8').split('\n');
  const found = lines.flatMap((line, index) => (line.includes(text) ? [index + 1] : []));
  if (found.length !== 1) {
    throw new Error(`${text} stands ${found.length} times in ${file}`);
  }
  return found[0];
}

/** Starts a program and resolves with it and its first `count` lines of output. */
function startAndRead(command, args, count) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, { stdio: ['pipe', 'pipe', 'inherit'] });
    let text = '';
    child.once('error', reject);
    child.once('exit', (code) => reject(new Error(`${command} ended with ${code}: ${text}`)));
    child.stdout.on('data', (data) => {
      text += data;
      const lines = text.split('\n');
      if (lines.length > count) {
        resolve({ child, lines: lines.slice(0, count).map((line) => line.trim()) });
      }
    });
  });
}

/** Ends a child process and waits until it is gone. */
function end(child) {
  return new Promise((resolve) => {
    if (child.exitCode !== null || child.signalCode !== null) {
      resolve();
      return;
    }
    child.removeAllListeners('exit');
    child.once('exit', () => resolve());
    child.kill();
  });
}

const MACHINE = ['--machine', path.join(LATHE, 'machine.toml'), '--clock', 'virtual'];

/** The three ways to a target: each gives its address and a function that takes it down. */
const TARGETS = {
  'in-process': async () => ({ address: 'embedded', stop: async () => {} }),

  TCP: async () => {
    const { child, lines } = await startAndRead(
      binary('technol'),
      ['target', '--listen', 'tcp:127.0.0.1:0', ...MACHINE],
      1,
    );
    const address = /tcp:\S+/.exec(lines[0]);
    return { address: address[0], stop: () => end(child) };
  },

  'serial line': async () => {
    const cable = await startAndRead(binary('pty-pair'), [], 2);
    const [left, right] = cable.lines;
    const target = await startAndRead(binary('technol'), ['target', '--serial', left, ...MACHINE], 1);
    return {
      address: `serial:${right}@115200`,
      stop: async () => {
        await end(target.child);
        await end(cable.child);
      },
    };
  },
};

module.exports = { LATHE, TARGETS, binary, lineOf };
