// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
package fallen.spy;

import java.awt.event.ActionEvent;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.Timer;
import lcm.spy.ChannelData;

/** A window that follows a channel until it is closed. */
final class ChannelWindow {
  private ChannelWindow() {}

  /**
   * An entry of lcm-spy's menu that opens such a window.
   *
   * @param show is given the panel and the channel's newest message, which is null before the first.
   */
  static <P extends JComponent> Action action(String text, ChannelData channel, int refreshMs,
      Supplier<P> makePanel, BiConsumer<P, Object> show) {
    return new AbstractAction(text) {
      @Override
      public void actionPerformed(ActionEvent event) {
        P panel = makePanel.get();
        JFrame frame = new JFrame(channel.name);
        frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
        frame.add(panel);
        frame.pack();
        frame.setVisible(true);
        new Timer(refreshMs, tick -> {
          if (!frame.isDisplayable()) ((Timer) tick.getSource()).stop();
          show.accept(panel, channel.last);
        }).start();
      }
    };
  }
}
