import assert from 'node:assert/strict';
import test from 'node:test';

import { Pace } from './pace.mjs';

const milliseconds = 1e6;

test('a board waits for the world, from its first moment on', () => {
    let now = 1000;
    const pace = new Pace(() => now);
    assert.equal(pace.wait(50 * milliseconds), 0);
    assert.equal(pace.wait(53 * milliseconds), 3);
    now += 3;
    assert.equal(pace.wait(53 * milliseconds), 0);
});

test('what was missed is not caught up', () => {
    let now = 0;
    const pace = new Pace(() => now);
    pace.wait(0);
    now = 500;
    assert.equal(pace.wait(1 * milliseconds), 0);
    assert.equal(pace.wait(2 * milliseconds), 1);
});
