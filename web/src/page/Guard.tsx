// SPDX-License-Identifier: MIT
/** If one part fails, a message replaces it and the rest of the report remains. */
import { Component, type ComponentChildren } from "preact";

interface Props {
  /** As in "The curve cannot be shown". */
  what: string;
  children?: ComponentChildren;
}

export class Guard extends Component<Props, { fault: string | null }> {
  state = { fault: null as string | null };

  componentDidCatch(error: unknown) {
    this.setState({ fault: error instanceof Error ? error.message : String(error) });
  }

  render() {
    if (this.state.fault === null) return <>{this.props.children}</>;
    return (
      <p class="fault" role="alert">
        {this.props.what} cannot be shown: {this.state.fault}. The other parts of the report are not affected.{" "}
        <button type="button" onClick={() => this.setState({ fault: null })}>
          Try again
        </button>
      </p>
    );
  }
}
