import fs from 'node:fs';

import { stories } from '../link_stories.mjs';
import { fail } from './emulation_error.mjs';
import { LinkHost } from './link_host.mjs';
import { light } from './report.mjs';

/** A computer that does with a board what a story says; the board goes on until the story is over. */
export class LinkTraffic {
    /** What the story tells. */
    told = {};

    constructor(wired, settings, values) {
        this.wired = { ...wired, settings, light: () => light(wired.board.mcu, settings.pins.backlight) };
        this.story = stories[values.link] ?? fail(`there is no story ${values.link}: ${Object.keys(stories)}`);
        this.files = Object.fromEntries(values.file.map((each) => each.split('='))
            .map(([name, file]) => [name, new Uint8Array(fs.readFileSync(file))]));
    }

    run() {
        const { board } = this.wired;
        const host = new LinkHost(board);
        this.told.names = host.setUp();
        Object.assign(this.told, this.story(host, this.files, this.wired));
        board.end('the story is over');
    }
}
