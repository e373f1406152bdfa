// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
package fallen.spy;

import fallen.service_status_t;
import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JDesktopPane;
import javax.swing.JFrame;
import javax.swing.Timer;
import lcm.spy.ChannelData;
import lcm.spy.SpyPlugin;

/** For lcm-spy: how a service does, in large letters. */
public class StatusPlugin implements SpyPlugin {
  private static final int REFRESH_MS = 500;

  @Override
  public boolean canHandle(long fingerprint) {
    return fingerprint == service_status_t.LCM_FINGERPRINT;
  }

  @Override
  public Action getAction(JDesktopPane desktop, ChannelData channel) {
    return new AbstractAction("Service status") {
      @Override
      public void actionPerformed(ActionEvent event) {
        StatusPanel panel = new StatusPanel();
        JFrame frame = new JFrame(channel.name);
        frame.setDefaultCloseOperation(JFrame.DISPOSE_ON_CLOSE);
        frame.add(panel);
        frame.pack();
        frame.setVisible(true);
        new Timer(REFRESH_MS, tick -> {
          if (!frame.isDisplayable()) ((Timer) tick.getSource()).stop();
          panel.show((service_status_t) channel.last);
        }).start();
      }
    };
  }
}
