// SPDX-License-Identifier: MIT
// CNCjs in front of a served machine: it connects, homes, jogs, cancels, probes, streams,
// overrides, holds, goes on and resets. By its server's own words, as its page speaks them.
//
//     node cncjs.js URL SECRET PORT
//
// Each step is told; the exit status is 0 where all have come about.
'use strict';

const client = require('socket.io-client');
const token = require('jsonwebtoken');

const [url, secret, port] = process.argv.slice(2);
const STEP_MS = 60000, LINES = 400;
const state = {grbl: {}, settings: {}, sender: {}, workflow: '', said: []};
const socket = client(url, {query: `token=${token.sign({id: '', name: 'test'}, secret)}`});
const command = (...words) => socket.emit('command', port, ...words);
const write = (data) => socket.emit('write', port, data);
const wait = (ms) => new Promise((done) => setTimeout(done, ms));

async function until(what, condition) {
    for (const end = Date.now() + STEP_MS; Date.now() < end; await wait(10)) {
        if (condition()) {
            console.log(what);
            return;
        }
    }
    throw new Error(`not within ${STEP_MS} ms: ${what}: ${JSON.stringify(state)}`);
}

const status = () => state.grbl.status || {};
const is = (name) => status().activeState === name;
const at = (axis) => Number((status().mpos || {})[axis]);
const has = (line) => state.said.some((said) => said.startsWith(line));

async function line(text, answer = 'ok') {
    state.said = [];
    command('gcode', text);
    await until(`${text}: ${answer}`, () => has(answer));
}

async function connect() {
    socket.emit('open', port, {controllerType: 'Grbl', baudrate: 115200});
    await until('connected', () => (state.settings.settings || {}).$110 !== undefined);
    await until('locked until it is homed', () => is('Alarm'));
}

async function home() {
    command('homing');
    await until('homed', () => is('Idle') && at('z') !== 0);
}

async function jog() {
    for (const stop of ['\x85', '!']) {
        const from = at('x');
        command('gcode', '$J=G91 X-40 F3000');
        await until('jogs', () => is('Jog') && at('x') !== from);
        write(stop);
        await until('the jog is cancelled', () => is('Idle'));
        if (Math.abs(at('x') - from) > 39) throw new Error('it was not');
    }
}

async function probe() {
    await line('G21 G90 G54');
    await line('G53 G0 Z-38');
    await line('G38.2 Z-60 F200', '[PRB:');
    if (!state.said.some((said) => /^\[PRB:.*:1\]/.test(said))) {
        throw new Error('it has touched nothing');
    }
    await line('G10 L20 P1 X0 Y0 Z0');
    await line('G0 Z5');
}

async function stream() {
    const lines = ['G21 G90 G94', 'G1 F1500'];
    for (let k = 1; k <= LINES; k++) {
        lines.push(`G1 X${(10 * Math.cos(k / 9) - 10).toFixed(3)} Y${(-k / 20).toFixed(3)}`);
    }
    command('gcode:load', 'job.nc', lines.join('\n') + '\n');
    await until('loaded', () => state.sender.total > LINES);
    command('gcode:start');
    await until('runs', () => is('Run') && state.sender.received > 20);
    command('feedOverride', 10);
    command('rapidOverride', 50);
    command('spindleOverride', -10);
    await until('overridden', () => String(status().ov) === '110,50,90');
    command('gcode:pause');
    await until('held', () => is('Hold'));
    command('gcode:resume');
    await until('goes on', () => is('Run'));
    await until('all lines are answered', () => state.sender.received === state.sender.total);
    await until('it has ended', () => state.workflow === 'idle' && is('Idle'));
    const y = Number(status().wpos.y);
    if (Math.abs(y + LINES / 20) > 5e-4) throw new Error(`the end is at ${y}`);
}

async function reset() {
    command('gcode', 'G91 G1 X-30 F600');
    await until('runs', () => is('Run'));
    state.said = [];
    command('reset');
    await until('a banner behind a reset', () => has('Grbl 1.1f'));
    await line('$X');
    await until('idle', () => is('Idle'));
}

async function main() {
    for (const step of [connect, home, jog, probe, stream, reset]) await step();
}

socket.on('serialport:read', (text) => state.said.push(text));
socket.on('Grbl:state', (grbl) => { state.grbl = grbl; });
socket.on('Grbl:settings', (settings) => { state.settings = settings; });
socket.on('sender:status', (sender) => { state.sender = sender; });
socket.on('workflow:state', (workflow) => { state.workflow = workflow; });
socket.on('connect_error', () => {});
socket.on('startup', () => main().then(() => process.exit(0), (cause) => {
    console.error(String(cause));
    process.exit(1);
}));
