// A field of a form: label, input with options, what is wrong with it.
let count = 0;

export default {
  props: { label: String, kind: String, value: String, options: Array, hint: String, unit: String, problem: String, title: String },
  data() {
    count += 1;
    return { id: `field-${count}` };
  },
  template: `
    <div class="field" :class="{ wrong: problem }">
      <label :for="id" :title="title || null">{{ label }}</label>
      <span class="entry">
        <select v-if="kind === 'choice'" :id="id" ref="entry" @change="tell" :aria-invalid="problem ? 'true' : null"
          :aria-describedby="problem ? id + '-problem' : null">
          <option v-for="one in options" :key="one" :value="one">{{ one }}</option>
        </select>
        <input v-else :id="id" ref="entry" autocomplete="off" spellcheck="false" :placeholder="hint || null"
          :inputmode="kind === 'number' ? 'decimal' : null" :list="kind === 'picker' ? id + '-options' : null"
          :aria-invalid="problem ? 'true' : null" :aria-describedby="problem ? id + '-problem' : null" @change="tell"
          @focus="offerAll" @blur="restore" @input="offered">
        <span v-if="unit" class="unit">{{ unit }}</span>
      </span>
      <datalist v-if="kind === 'picker'" :id="id + '-options'"><option v-for="one in options" :key="one" :value="one"></option></datalist>
      <p v-if="problem" :id="id + '-problem'" class="problem" role="alert">{{ problem }}</p>
    </div>`,
  mounted() {
    this.$refs.entry.value = this.value;
    this.sent = this.value;
  },
  updated() {
    if (this.kind === "choice" && this.$refs.entry.value !== this.sent) this.$refs.entry.value = this.sent;
  },
  watch: {
    value(now) {
      this.sent = now;
      if (this.$refs.entry !== document.activeElement || this.$refs.entry.value === this.before) this.$refs.entry.value = now;
      this.before = now;
    },
  },
  methods: {
    tell() {
      const now = this.$refs.entry.value;
      if (now === this.sent) return;
      this.sent = now;
      this.before = now;
      this.$emit("changed", now);
    },
    offerAll() { // a list of options shows those that contain the text: select it, so that typing replaces it
      this.before = this.$refs.entry.value;
      if (this.kind === "picker") this.$refs.entry.select();
    },
    offered(event) { // a choice from the list, by mouse or Enter, counts at once
      if (this.kind === "picker" && !(event instanceof InputEvent && event.inputType && event.inputType !== "insertReplacementText")) this.tell();
    },
    restore() {
      if (this.kind === "picker" && this.$refs.entry.value === "" && !this.hint) this.$refs.entry.value = this.sent;
    },
  },
};
