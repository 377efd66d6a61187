// The sound of the brakes: a low hum, the louder the larger the torque of the brakes that slip. It is off
// until the visitor turns it on.

const pitch = 110,
  loudest = 0.12; // [Hz], [1]

export function make_sound() {
  let context = null,
    gain = null;
  return {
    is_on: false,
    turn(is_on) {
      this.is_on = is_on;
      if (is_on && !context) {
        context = new AudioContext();
        const tone = context.createOscillator(),
          filter = context.createBiquadFilter();
        tone.type = 'sawtooth';
        tone.frequency.value = pitch;
        filter.type = 'lowpass';
        filter.frequency.value = 6 * pitch;
        gain = context.createGain();
        gain.gain.value = 0;
        tone.connect(filter).connect(gain).connect(context.destination);
        tone.start();
      }
      if (context) is_on ? context.resume() : context.suspend();
    },
    // level: 0 to 1.
    play(level) {
      if (this.is_on)
        gain.gain.setTargetAtTime(loudest * Math.min(1, Math.max(0, level)), context.currentTime, 0.015);
    },
  };
}
