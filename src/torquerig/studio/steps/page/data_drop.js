// A place for files: drop them, or choose them; each is sent whole to the folder of the studio.
export default {
  props: { address: String },
  data() {
    return { over: false, busy: "" };
  },
  template: `
    <div class="drop" :class="{ over }" @dragover.prevent="over = true" @dragleave="over = false" @drop.prevent="dropped">
      <label>Drop recordings here, or choose them:
        <input type="file" multiple ref="entry" @change="chosen">
      </label>
      <p role="status">{{ busy }}</p>
    </div>`,
  methods: {
    dropped(event) {
      this.over = false;
      this.send([...event.dataTransfer.files]);
    },
    async chosen() {
      await this.send([...this.$refs.entry.files]);
      this.$refs.entry.value = "";
    },
    async send(files) {
      const said = [];
      for (const file of files) {
        this.busy = `Receiving ${file.name}.`;
        said.push(await this.sendOne(file));
      }
      this.busy = "";
      this.$emit("received", said);
    },
    async sendOne(file) {
      try {
        const answer = await fetch(`${this.address}?name=${encodeURIComponent(file.name)}`, { method: "POST", body: file });
        const text = await answer.text();
        return { name: file.name, ok: answer.ok, text };
      } catch (error) {
        return { name: file.name, ok: false, text: `${file.name}: was not received; the studio does not answer` };
      }
    },
  },
};
